# Counts the words of sentences. Reads what markdown_prose.awk prints, or check_contracts.awk with -v prose=1.
# usage: awk -f sentences.awk [-v max=40] [-v statistics=1] < prose
# Prints file:line: number of words: sentence for each sentence that has more than `max` words; the exit code is 1 if there is one. With `statistics`
# it prints the number of sentences, their average length and the number of long ones for each file and for all files, and the exit code is 0.
#
# A sentence ends at . ! or ? before a space, at the end of a paragraph, of a list item and of a comment, and where Needs: Result: Cost: Errors: or
# Source: begins. Colons and semicolons do not end it, nor do "e.g." and the like, nor points in numbers. A word has a letter or a digit; a code span
# between backquotes is one word. Code in comments is left out: lines indented by three spaces or more that are not below a label. The statistics
# leave out answers of one or two words such as "none." and "O(1).", which would make the average look better than it is.

BEGIN {
  FS = "\t"
  if (max == "") max = 40
  abbreviations = " e.g. i.e. etc. cf. vs. resp. approx. "
  before_numbers = " al. fig. eq. no. p. pp. sec. vol. "
}

function end_sentence() {
  if (words > 2) {
    ++sentences[file]
    total[file] += words
  }
  if (words > max) {
    ++long[file]
    found = 1
    if (!statistics) print file ":" first_line ": " words " words: " sentence
  }
  words = 0
  sentence = ""
}

function ends_sentence(word, next_word) {
  sub(/["')\]*_]+$/, "", word)
  if (word !~ /[.!?]$/ || word == "..") return 0
  sub(/^["'(\[*_]+/, "", word)
  if (index(abbreviations, " " tolower(word) " ")) return next_word == ""
  if (index(before_numbers, " " tolower(word) " ") && next_word ~ /^[(]?[0-9]/) return 0
  return word !~ /\.\.\.$/ || next_word ~ /^[("'\[]*[A-Z`]/
}

function add_word(word, line, next_word) {
  if (word ~ /^(Needs|Result|Cost|Errors|Source):$/) {
    end_sentence()
    return
  }
  if (sentence == "") first_line = line
  sentence = sentence (sentence == "" ? "" : " ") word
  if (word ~ /[A-Za-z0-9`]/) ++words
  if (ends_sentence(word, next_word)) end_sentence()
}

# Spaces and line ends within code spans are hidden while the paragraph is cut into words.
function end_paragraph(    i, n, pieces, text, list, line, word, more_lines) {
  n = split(paragraph, pieces, "`")
  text = pieces[1]
  for (i = 2; i <= n; ++i) {
    if (i % 2 == 0 && i < n) {
      gsub(/[ \t]/, "\001", pieces[i])
      gsub(/\n/, "\002", pieces[i])
    }
    text = text "`" pieces[i]
  }
  gsub(/\n/, " \n ", text)
  n = split(text, list, /[ \t]+/)
  line = paragraph_line
  for (i = 1; i <= n; ++i) {
    word = list[i]
    if (word == "\n") ++line
    if (word == "" || word == "\n") continue
    gsub(/\001/, " ", word)
    more_lines = gsub(/\002/, " ", word)
    add_word(word, line, list[i + 1] == "\n" ? list[i + 2] : list[i + 1])
    line += more_lines
  }
  end_sentence()
  paragraph = ""
}

$1 != file || $3 == "" {
  if (paragraph != "") end_paragraph()
  labelled = 0
  if ($1 != file) files[++num_files] = $1
  file = $1
  if ($3 == "") next
}

{
  text = $3
  for (i = 4; i <= NF; ++i) text = text " " $i
  if (text ~ /^ *(Needs|Result|Cost|Errors|Source):/) labelled = 1
  is_code = !labelled && text ~ /^   /
  if (paragraph != "" && (is_code || text ~ /^ *([-*]|[0-9]+\.) /)) end_paragraph()
  if (is_code) next
  sub(/^ *([-*]|[0-9]+\.) +/, "", text)
  if (paragraph == "") paragraph_line = $2
  paragraph = paragraph (paragraph == "" ? "" : "\n") text
}

END {
  if (paragraph != "") end_paragraph()
  if (!statistics) exit found
  files[++num_files] = "all of these"
  for (i = 1; i <= num_files; ++i) {
    f = files[i]
    if (!sentences[f]) continue
    printf "%5d sentences, %4.1f words on average, %3d of more than %d words: %s\n", sentences[f], total[f] / sentences[f], long[f], max, f
    sentences["all of these"] += sentences[f]
    total["all of these"] += total[f]
    long["all of these"] += long[f]
  }
}
