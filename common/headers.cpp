// Nothing of its own: CMake compiles the headers that nearly all share beside it (CMakeLists.txt).
