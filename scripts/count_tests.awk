# Reads ctest's LastTest.log. Prints "passed failed"; the output of failed tests goes to stderr, the names of skipped ones to the file
# `skips`. A doctest program counts as its test cases, anything else as one test.
function end_of_test(  cases_passed, cases_failed) {
  if (name == "") return
  if (summary != "") {
    split(summary, part, "|")
    cases_passed = part[2] + 0 - skips_here
    cases_failed = part[3] + 0
    if (!ok && cases_failed == 0) cases_failed = 1        # a crash, a sanitizer's report, a time-out
  } else {
    cases_passed = ok && !skips_here
    cases_failed = !ok
  }
  passed += cases_passed
  failed += cases_failed
  if (!ok) print "FAILED: " name "\n" text > "/dev/stderr"
  name = ""
}
/^[0-9]+\/[0-9]+ Testing: / {
  end_of_test()
  sub(/^[0-9]+\/[0-9]+ Testing: /, "")
  name = $0; text = ""; summary = ""; skips_here = 0; ok = 0
  next
}
/^Test Passed\.$/ { ok = 1; next }
/^\[doctest\] test cases:/ { summary = $0 }
/^SKIPPED: / { ++skips_here; print name " - " substr($0, 10) >> skips }
name != "" && !/^(Command|Directory|Output):|^"|^[0-9]+\/[0-9]+ Test: |^-+$/ { text = text "  " $0 "\n" }
END { end_of_test(); print passed + 0, failed + 0 }
