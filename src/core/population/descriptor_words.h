#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The English that household descriptors are written in.
namespace pcg::descriptor_words {

using Words = std::vector<std::string>;

// Lists of words with spaces between them.
inline constexpr std::string_view adult_words = "adult adults person persons people member members parent parents";
inline constexpr std::string_view woman_words = "woman women mother mothers female females lady ladies wife";
inline constexpr std::string_view man_words = "man men father fathers male males gentleman gentlemen husband";
inline constexpr std::string_view elder_words = "retired elder elders elderly senior seniors old pensioner pensioners";
inline constexpr std::string_view minor_words = "minor minors child children kid kids";
inline constexpr std::string_view boy_words = "boy boys son sons";
inline constexpr std::string_view girl_words = "girl girls daughter daughters";
inline constexpr std::string_view couple_words = "couple couples";
inline constexpr std::string_view filler_words = "and with of the household households family families in living other own lone single married "
										  "cohabiting age is are their plus both year years old who also unmarried";

// Lower-case words and numbers; "16-64" becomes "16" "to" "64", "65+" becomes "65" "or" "more".
Words split_words(std::string_view text);
bool is_one_of(std::string_view word, std::string_view list);
bool is_plural(std::string_view noun);
// "no" .. "ten", "a", "an" or up to three digits.
std::optional<int> number_of(std::string_view word);

} // namespace pcg::descriptor_words
