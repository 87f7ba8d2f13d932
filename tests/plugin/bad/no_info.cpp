// Has the entry point, but it answers with nothing.
#include <delos/plugin.h>

extern "C" DELOS_API const delos::PluginInfo* delos_plugin() { return nullptr; }
