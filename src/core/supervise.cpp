#include "stepmill/core/supervise.h"
