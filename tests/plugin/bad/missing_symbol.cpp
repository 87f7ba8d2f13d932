// A library which isn't a plugin: it names the entry point, but only to call it, and
// leaves a mark where any of its code runs.
#include <cstdlib>

extern "C" __attribute__((weak)) const void* delos_plugin();

static const int ran = setenv("DELOS_TEST_MISSING_SYMBOL_RAN", "1", 1);

extern "C" __attribute__((visibility("default"))) int some_function() {
  return ran + (delos_plugin ? 1 : 0);
}
