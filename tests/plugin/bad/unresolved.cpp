// Calls a function that no kernel has; it would end the program when called.
#include <delos/plugin.h>

extern "C" int delos_test_no_such_function();

extern "C" DELOS_API const delos::PluginInfo* delos_plugin() {
  return delos_test_no_such_function() ? nullptr : nullptr;
}
