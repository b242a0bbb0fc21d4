#include "nodes/common/names.h"
