// Nothing of its own: CMake compiles the headers that the tests share beside it (tests/CMakeLists.txt).
