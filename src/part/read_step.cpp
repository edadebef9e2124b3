#include "stepmill/part/part.h"
