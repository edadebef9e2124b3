#include "stepmill/planar/region_text.h"
