// Read by the leak sanitizer alone: Fontconfig 2.14 keeps a few patterns to the end of
// the process, about 1 kB however many pictures are drawn.
extern "C" __attribute__((visibility("default"))) const char*
__lsan_default_suppressions();

const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
