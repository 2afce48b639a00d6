#include "core/lang/vm.h"
