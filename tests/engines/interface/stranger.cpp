// A shared module that is no plug-in.

extern "C" __attribute__((visibility("default"))) int tautline_stranger() { return 0; }
