#include "support/heap_count.h"

#include <cerrno>

#include "delos/api.h"

namespace {

thread_local bool counting = false;
thread_local std::size_t count = 0;

void note() {
  if (counting) ++count;
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__

// The sanitizer owns malloc and reports to us. GCC doesn't ship the header of this.
extern "C" int __sanitizer_install_malloc_and_free_hooks(
    void (*on_malloc)(const volatile void*, std::size_t),
    void (*on_free)(const volatile void*));

static const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { note(); }, [](const volatile void*) {});

#else

// glibc's own entries, which stay reachable behind ours.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

DELOS_API void* malloc(std::size_t size) {
  note();
  return __libc_malloc(size);
}
DELOS_API void* calloc(std::size_t n, std::size_t size) {
  note();
  return __libc_calloc(n, size);
}
DELOS_API void* realloc(void* p, std::size_t size) {
  note();
  return __libc_realloc(p, size);
}
DELOS_API void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note();
  return __libc_memalign(alignment, size);
}
DELOS_API int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  note();
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
}

#endif

namespace delos::test {

std::size_t allocations(const std::function<void()>& work) {
  count = 0;
  counting = true;
  work();
  counting = false;
  return count;
}

}  // namespace delos::test
