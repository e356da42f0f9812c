// For the sanitized build only. The Vulkan loader unloads its driver before the process ends. A leak that
// LeakSanitizer then finds in the driver has no module, and no suppression can name it.
extern "C" int dlclose(void*) {
  return 0;
}
