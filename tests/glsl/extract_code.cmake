# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# cmake -DREADME=FILE -DLANGUAGE=c -DINDEX=0 -DOUTPUT=FILE -P extract_code.cmake: writes one of the code blocks of a
# language out of a Markdown file.
file(READ ${README} text)
# Semicolons and brackets mean something to CMake's lists.
foreach(i RANGE ${INDEX})
    string(FIND "${text}" "```${LANGUAGE}\n" at)
    if(at EQUAL -1)
        message(FATAL_ERROR "expected code block ${INDEX} of \"${LANGUAGE}\" in ${README}, found ${i}")
    endif()
    string(LENGTH "```${LANGUAGE}\n" length)
    math(EXPR at "${at} + ${length}")
    string(SUBSTRING "${text}" ${at} -1 text)
endforeach()
string(FIND "${text}" "```" end)
string(SUBSTRING "${text}" 0 ${end} text)
file(WRITE ${OUTPUT} "${text}")
