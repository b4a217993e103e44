# Finds lines of more than 120 columns. These may be longer: an #include, what compilers print as one line (#error, a static_assert with its text, a deleted
# overload with its comment, a sentence or mistake::remedy, a concept with a comment that says what else to write), a line that is one string literal, and
# what stands between `clang-format off` and `clang-format on`.
# usage: awk -f check_columns.awk [-v most=120] files...     Prints file:line: columns; the exit code is 1 where a line is too long.
BEGIN { if (!most) most = 120 }
FNR == 1 { is_off = 0 }
/clang-format off/ { is_off = 1 }
/clang-format on/ { is_off = 0 }
length($0) > most && !is_off && !/^[ \t]*#(include|error)/ && !/= delete;|mistake::remedy<|static_assert\(.*"|constexpr sentence |;  \/\/ else / && !/^[ \t]*[:{]?[ \t]*"([^"\\]|\\.)*"[^"]*$/ {
  print FILENAME ":" FNR ": " length($0) " columns"
  found = 1
}
END { exit found }
