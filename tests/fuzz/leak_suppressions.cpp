// Read by the leak sanitizer alone: UDUNITS keeps words of units that it couldn't
// understand to the end of the process.
extern "C" __attribute__((visibility("default"))) const char*
__lsan_default_suppressions();

const char* __lsan_default_suppressions() { return "leak:libudunits2"; }
