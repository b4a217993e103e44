# Finds sums of strings in C++ sources. A sum is code at the place of each message, and g++ 12 at -O3 takes some for overlapping copies;
# core::joined and core::throw_joined put messages together out of line.
# usage: awk -f string_sums.awk files...     Prints file:line: source for each sum; the exit code is 1 where there is one.

BEGIN {
  inner = "([^()]|\\(([^()]|\\([^()]*\\))*\\))*"
  call = "((std::)?(to_string|number_text)\\(" inner "\\)|std::string[({]" inner "[)}])"
  sum = "\"\\+[^+=]|[^+]\\+\"|(^|[^a-z_:])" call "\\+[^+=]|[^+]\\+" call
}

FNR == 1 { previous = "" }

{
  line = $0
  gsub(/\\\\|\\"|\\'/, "", line)  # escaped quotes
  gsub(/'[^']'/, "0", line)       # characters
  gsub(/"[^"]*"/, "\"", line)     # from here on a text is one quote
  sub(/\/\/.*/, "", line)
  gsub(/[ \t]+/, "", line)
  if (line == "" || line ~ /^#/) next
  joint = previous ~ /\+$/ || line ~ /^\+/ ? previous line : line  # a sum may go on in the next line
  previous = line
  if (joint ~ sum) {
    print FILENAME ":" FNR ": " $0
    found = 1
  }
}

END { exit found ? 1 : 0 }
