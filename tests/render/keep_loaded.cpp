// For the sanitized build only. The Vulkan loader unloads its driver before the process ends; a leak that
// LeakSanitizer then finds there has no module, and no suppression can name it.
extern "C" int dlclose(void*) {
  return 0;
}
