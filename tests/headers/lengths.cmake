# No function has more than 60 lines: scripts/check_lengths.awk says how they are counted.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${source} ${source}/concepts/*.hpp ${source}/include/*.hpp ${source}/include/*.ipp ${source}/adapters/*.hpp)
find_program(awk NAMES awk REQUIRED)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_lengths.awk ${headers} WORKING_DIRECTORY ${source} OUTPUT_VARIABLE found RESULT_VARIABLE code)
if(found OR NOT code EQUAL 0)
  message(FATAL_ERROR "functions of more than 60 lines; divide them into smaller functions:\n${found}")
endif()

# The check itself finds long functions, members and templates, and accepts short ones, classes, namespaces and tables.
string(REPEAT "  f(\"{\", '{');  // {\n" 58 lines)
string(REPEAT "  1,\n" 80 values)
file(WRITE ${scratch}/short.hpp
  "namespace n {\nint table[] = {\n${values}};\nint f() {\n${lines}}\nclass c : public base<c> {\n  c() : x(1) {\n${lines}  }\n  void g() {\n${lines}  }\n};\n}\n")
file(WRITE ${scratch}/long.hpp
  "namespace n {\nint f() {\n${lines}\n}\nclass c : public base<c> {\n  template<class T>\n    requires is_good<T>\n  void g(T) {\n    auto h = [] {\n${lines}    };\n  }\n};\n}\n")
execute_process(COMMAND ${awk} -f ${source}/scripts/check_lengths.awk ${scratch}/short.hpp OUTPUT_VARIABLE found_short RESULT_VARIABLE short)
execute_process(COMMAND ${awk} -f ${source}/scripts/check_lengths.awk ${scratch}/long.hpp OUTPUT_VARIABLE found RESULT_VARIABLE long)
if(NOT short EQUAL 0 OR NOT long EQUAL 1 OR NOT found MATCHES "long.hpp:2: 61 lines: int f.*long.hpp:66: 62 lines: void g")
  message(FATAL_ERROR "scripts/check_lengths.awk does not distinguish long functions from short ones: ${short} ${found_short} ${long} ${found}")
endif()
