// Made for a later contract: behind its stamp is nothing that this kernel could read.
#include <delos/plugin.h>

#include <cstring>

namespace {

struct LaterInfo {
  delos::AbiStamp abi;
  unsigned char unreadable[256];
};

LaterInfo make() {
  LaterInfo info{delos::this_abi(), {}};
  info.abi.epoch += 1;
  // All fields of a PluginInfo would be wild pointers.
  std::memset(info.unreadable, 0xff, sizeof info.unreadable);
  return info;
}

}  // namespace

extern "C" DELOS_API const void* delos_plugin() {
  static const LaterInfo info = make();
  return &info;
}
