// A library which isn't a plugin, and leaves a mark where any of its code runs.
#include <cstdlib>

static const int ran = setenv("DELOS_TEST_MISSING_SYMBOL_RAN", "1", 1);

extern "C" __attribute__((visibility("default"))) int some_function() { return ran; }
