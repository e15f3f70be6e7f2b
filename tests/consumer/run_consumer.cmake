# Called by CTest, see CMakeLists.txt beside this file.
cmake_minimum_required(VERSION 3.20)

function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    message(FATAL_ERROR "${what} failed (${failed}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Writes the first C++ block of a Markdown file to `target`.
function(extract_program markdown target)
  file(READ "${markdown}" text)
  string(FIND "${text}" "```cpp\n" start)
  if(start EQUAL -1)
    message(FATAL_ERROR "${markdown} has no block that starts with ```cpp")
  endif()
  math(EXPR start "${start} + 7")
  string(SUBSTRING "${text}" ${start} -1 text)
  string(FIND "${text}" "```" length)
  string(SUBSTRING "${text}" 0 ${length} program)
  file(WRITE "${target}" "${program}")
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/project" DESTINATION "${WORK}")
extract_program("${SHERD_SOURCE}/README.md" "${WORK}/project/main.cpp")

run("Installing" ${CMAKE_COMMAND} --install "${SHERD_BUILD}" --config "${CONFIG}" --prefix "${WORK}/prefix")
run("Configuring" ${CMAKE_COMMAND} -S "${WORK}/project" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=$<1:${WORK}/bin>" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run("Building" ${CMAKE_COMMAND} --build "${WORK}/build" --config "${CONFIG}")

# The program looks for assets/coffee_cup.obj from where it is started.
file(COPY "${SHERD_SOURCE}/assets/coffee_cup.obj" DESTINATION "${WORK}/run/assets")
run("Running the program of the README" ${CMAKE_COMMAND} -E chdir "${WORK}/run" "${WORK}/bin/program")
if(NOT output MATCHES "broke into [0-9]+ pieces")
  message(FATAL_ERROR "The cup did not break:\n${output}")
endif()
run("Running the program that uses everything" "${WORK}/bin/everything")
run("Running the program whose world is a global" "${WORK}/bin/globals")
