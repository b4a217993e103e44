# Joins the rows of the benchmark programs with the budgets. Prints the table of works and the table of curves, and writes both as JSON.
# usage: awk -v json=FILE -v about="COMPILER AND DATE" -f report.awk budgets.tsv rows.tsv...

BEGIN { FS = "\t"; steeper = 0.15 }   # a slope is too steep if it exceeds the expected slope by more than this
/^#/ { next }
FILENAME == ARGV[1] { against[$1] = $2; limit[$1] = $3; next }
$1 == "point" {
  if (!($2 in points)) curve[++curves] = $2
  model[$2] = $3; n = ++points[$2]
  elements[$2, n] = $4; ours_at[$2, n] = $5; floor_at[$2, n] = $6
  next
}
{
  work = $1; who = $2
  if (!(work in unit)) { order[++works] = work; unit[work] = $3; names[work] = "" }
  if (!((work, who) in value)) names[work] = names[work] (names[work] == "" ? "" : SUBSEP) who
  value[work, who] = $4; ours_over[work, who] = $5
}

function show(x) { return x == "" ? "-" : sprintf(x >= 100 ? "%.0f" : x >= 0.1 ? "%.3f" : "%.5f", x) }

# The library's value divided by the value that the budget names, or "" if that was not measured.
function measured(work,   a, part) {
  if (!((work, "concino") in value)) return ""
  a = against[work]
  if (a == "-") return value[work, "concino"]
  if (split(a, part, ":") == 2) return (part[1], part[2]) in value ? value[work, "concino"] / value[part[1], part[2]] : ""
  return (work, a) in value ? ours_over[work, a] : ""
}

# The logarithm of the model "n", "n log n" or "n^k", where x is the logarithm of n.
function growth(model, x) { return model == "n" ? x : model ~ /^n\^/ ? substr(model, 3) * x : x + log(x) }

# The slope of the line that fits the points of a curve best in a log-log plot. `which` selects the values: "ours", "floor" or "expected".
function slope(name, which,   k, n, x, y, sx, sy, sxx, sxy) {
  n = points[name]
  for (k = 1; k <= n; ++k) {
    x = log(elements[name, k])
    y = which == "ours" ? log(ours_at[name, k]) : which == "floor" ? log(floor_at[name, k]) : growth(model[name], x)
    sx += x; sy += y; sxx += x * x; sxy += x * y
  }
  return n < 2 ? 1 : (n * sxy - sx * sy) / (n * sxx - sx * sx)
}

function print_works(   i, k, n, work, name, line, best, is, met, budget, comma, missed, judged) {
  format = "%-44s %6s %10s %10s %7s  %-20s %10s %7s  %-26s %7s  %s\n"
  printf format, "work", "unit", "floor", "concino", "ratio", "best peer", "", "ratio", "budget", "value", "met"
  for (i = 1; i <= works; ++i) {
    work = order[i]; n = split(names[work], name, SUBSEP); best = ""
    line = ""
    for (k = 1; k <= n; ++k) {
      line = line (k > 1 ? ", " : "") \
        sprintf("\"%s\": {\"value\": %s, \"concino_over_it\": %s}", name[k], value[work, name[k]], ours_over[work, name[k]])
      if (name[k] != "floor" && name[k] != "concino" && (best == "" || value[work, name[k]] + 0 < value[work, best] + 0)) best = name[k]
    }
    is = work in limit ? measured(work) : ""
    met = is == "" ? "" : (is + 0 <= limit[work] + 0 ? "yes" : "NO")
    if (met == "NO") ++missed
    if (met != "") ++judged
    budget = !(work in limit) ? "" : "<= " limit[work] (against[work] == "-" ? "" : " x " against[work])
    printf format, work, unit[work], show(value[work, "floor"]), show(value[work, "concino"]), show(ours_over[work, "floor"]),
      best, best == "" ? "" : show(value[work, best]), best == "" ? "" : show(ours_over[work, best]), budget, show(is), met
    printf "%s    {\"work\": \"%s\", \"unit\": \"%s\", \"contenders\": {%s}", comma, work, unit[work], line > json
    comma = ",\n"
    if (is != "")
      printf ", \"budget\": {\"against\": \"%s\", \"limit\": %s, \"is\": %.4g, \"met\": %s}", against[work], limit[work], is,
        met == "yes" ? "true" : "false" > json
    printf "}" > json
  }
  printf "%d budgets checked, %d missed\n", judged, missed
}

# Nanoseconds or bytes per element at each size, and the slope of the whole.
function print_curves(   i, k, n, name, per, line, line_floor, ours, expected, floor, flagged, comma) {
  printf "\n%-33s %-42s %5s  %8s  %5s\n", "growth: ns or bytes per poly", "10^4  ...  10^6.5", "slope", "expected", "floor"
  for (i = 1; i <= curves; ++i) {
    name = curve[i]; n = points[name]; line = line_floor = per = ""
    for (k = 1; k <= n; ++k) {
      per = per sprintf("%6.4g ", ours_at[name, k] / elements[name, k] * (name ~ /memory/ ? 1 : 1e9))
      line = line (k > 1 ? ", " : "") sprintf("{\"elements\": %s, \"concino\": %s, \"floor\": %s}", elements[name, k], ours_at[name, k], floor_at[name, k])
    }
    ours = slope(name, "ours"); floor = slope(name, "floor"); expected = slope(name, "expected")
    steep = ours > expected + steeper && ours > floor + steeper / 3
    flagged += steep
    remark = steep ? "STEEP" : (ours > expected + steeper) ? "steep like the floor (caches)" : ""
    printf "%-33s %-42s %5.2f  %8.2f  %5.2f  %s\n", name, per, ours, expected, floor, remark
    printf "%s    {\"work\": \"%s\", \"model\": \"%s\", \"slope\": %.3f, \"expected\": %.3f, \"slope_of_floor\": %.3f, \"steep\": %s, \"points\": [%s]}", comma,
      name, model[name], ours, expected, floor, steep ? "true" : "false", line > json
    comma = ",\n"
  }
  printf "%d curves, %d steeper than expected\n", curves, flagged
}

END {
  print "{\n  \"about\": \"" about "\",\n  \"works\": [" > json
  print_works()
  print "\n  ],\n  \"curves\": [" > json
  if (curves) print_curves()
  print "\n  ]\n}" > json
}
