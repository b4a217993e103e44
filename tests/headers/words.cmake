# No header declares a name of scripts/words.txt, and no sentence of the pages and the contracts has more than 40 words: scripts/check_words.sh.
cmake_minimum_required(VERSION 3.25)
find_program(bash NAMES bash REQUIRED)

# run(<variable> <folder> <argument>...): what the script prints there; <variable>_code is its exit code.
function(run variable folder)
  execute_process(COMMAND ${bash} ${source}/scripts/check_words.sh ${ARGN} WORKING_DIRECTORY ${folder}
    RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE wrong)
  if(code EQUAL 3)
    get_property(is_skipped GLOBAL PROPERTY is_skipped SET)
    if(NOT is_skipped)
      message(NOTICE "SKIPPED: headers/words: ${wrong}")
      set_property(GLOBAL PROPERTY is_skipped TRUE)
    endif()
    return()
  elseif(wrong OR code GREATER 1)
    message(FATAL_ERROR "check_words.sh ${ARGN}: exit code ${code}\n${wrong}${said}")
  endif()
  set(${variable} "${said}" PARENT_SCOPE)
  set(${variable}_code ${code} PARENT_SCOPE)
endfunction()

# expect(<option> <file below scratch> <text> <regular expression of all that is printed; empty: nothing>)
function(expect option name text wanted)
  file(WRITE ${scratch}/${name} "${text}")
  unset(said_code)
  run(said ${scratch} --${option} ${name})
  if(DEFINED said_code AND (NOT said MATCHES "^${wanted}$" OR (said STREQUAL "" AND NOT said_code EQUAL 0) OR (NOT said STREQUAL "" AND NOT said_code EQUAL 1)))
    message(FATAL_ERROR "check_words.sh --${option} ${name} should print \"${wanted}\", but prints \"${said}\" with exit code ${said_code}")
  endif()
endfunction()

# What a sentence is: 40 words pass, 41 do not.
string(REPEAT "word " 38 words)
expect(sentences short.md "# Title\n\n${words}`two words` end.\n${words}e.g. two, 3.5.\n" "short.md:4: 41 words: [^\n]*\n")
expect(sentences span.md "One. Two.\n${words}`a\nb` one; two: end.\n" "span.md:2: 42 words: [^\n]*\n")
expect(sentences left_out.md "```\n${words}${words}\n```\n\n    ${words}${words}\n\n| ${words}${words} |\n\n- ${words}\n- ${words}\n\n${words}\n\n${words}\n" "")
expect(sentences link.md "[${words}](a.md) three in all.\n" "link.md:1: 41 words: [^\n]*\n")
set(before "// A header.\n#pragma once\nnamespace concino {\n\n")
expect(sentences labels.hpp "${before}/// ${words}\n/// Needs:  ${words}\n///         two.      Cost: ${words}\nvoid f();\n}\n" "")
expect(sentences contract.hpp "${before}/// A sentence.\n/// Needs:  ${words}\n///         three in all.\nvoid f();\n}\n" "contract.hpp:6: 41 words: [^\n]*\n")
expect(sentences code.hpp "${before}/// A sentence:\n///   ${words}${words}\nvoid f();\n}\n" "")
expect(sentences inside.hpp "${before}namespace detail {\n/// ${words}${words}\nvoid f();\n}\n}\n" "")
run(said ${scratch} --statistics short.md)
if(NOT said MATCHES "2 sentences, 40\\.5 words on average,   1 of more than 40 words: all of these\nshort.md:4: 41 words")
  message(FATAL_ERROR "check_words.sh --statistics prints:\n${said}")
endif()

# Names: types, concepts, functions and members, in detail too, but no local variables, and `rows` of a matrix.
expect(names right.hpp "struct matrix {\n  int rows() const;\n  int right_hand_side;\n};\ninline int at_least(int least) {\n  const int most = least;\n  return most;\n}\n" "")
expect(names wrong.hpp "namespace concino::detail {\nclass rows {\n  int sides_;\n};\ntemplate<class T>\nconcept walkable = true;\ntemplate<class T>\n  requires walkable<T>\nint most_edges(T t) {\n  return t.least();\n}\n}\n"
  "wrong.hpp:2: class rows: [^\n]*\nwrong.hpp:3: member sides_: [^\n]*\nwrong.hpp:6: variable walkable: [^\n]*\nwrong.hpp:9: function most_edges: [^\n]*\n")

set(said "")
run(said ${source})
if(said)
  string(REPLACE "\n" "\n  " said "  ${said}")  # lines that begin with spaces are not wrapped
  message(FATAL_ERROR "names that scripts/words.txt rules out, or sentences of more than 40 words:\n${said}")
endif()
