#pragma once

// What sanitizers must know about OSMesa, which is not built with them. They ask for these
// functions by name, so every program that draws knows. Included by context.cpp only; empty in
// other builds.

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define REGARMENT_LEAK_CHECK
#endif
#if __has_feature(thread_sanitizer)
#define REGARMENT_RACE_CHECK
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define REGARMENT_LEAK_CHECK
#endif
#if defined(__SANITIZE_THREAD__)
#define REGARMENT_RACE_CHECK
#endif

#if defined(REGARMENT_LEAK_CHECK)
// OSMesa's screen and window stay until the process ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

#if defined(REGARMENT_RACE_CHECK)
// OSMesa's locks go to the kernel directly, unseen.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() { return "race:libOSMesa\n"; }
extern "C" const char* __tsan_default_options();
extern "C" const char* __tsan_default_options() { return "print_suppressions=0"; }
#endif
