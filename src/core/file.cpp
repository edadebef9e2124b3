#include "stepmill/core/file.h"
