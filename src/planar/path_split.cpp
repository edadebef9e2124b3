#include "stepmill/planar/boolean.h"
