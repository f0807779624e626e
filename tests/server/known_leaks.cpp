// What a library leaves allocated is not ours to report: PocketSphinx, a grammar of each alignment.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libsphinxbase\n";
}
