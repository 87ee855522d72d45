# SPDX-License-Identifier: MIT
# Reads the log of ctest; prints what failed with its output, then one line that counts; fails if a test did, or if none
# ran.
/^ *[0-9]+\/[0-9]+ Test +#/ {
    ran++
    shown = !/ Passed /
    passed += !shown
}
/^[0-9]+% tests passed/ { finished = 1; shown = 0 }
shown && !/^ +Start +[0-9]+: / { print }
!finished { tail = tail $0 "\n" }
END {
    if (!finished || !ran) { printf "%stest: ctest did not finish\n", tail; exit 1 }
    printf "test: %d passed, %d failed\n", passed, ran - passed
    exit ran != passed
}
