#!/usr/bin/env bash
# tests/timed.sh COMMAND...: runs a test's command, and appends the processor time that it took to the file
# $THAUM_CASE_TIMES: milliseconds, a tab, and the command without folders. ./thaum test prints the dearest cases from it.
[[ -n ${THAUM_CASE_TIMES:-} ]] || exec "$@"
exec 3>&1 4>&2
TIMEFORMAT='%U %S'
spent=$({ time "$@" >&3 2>&4 3>&- 4>&-; } 2>&1)
result=$?
read -r user system <<<"$spent"
words=$(sed 's|[^ =:]*/||g; s|--gtest_filter=||; s| --gtest_also_run_disabled_tests||' <<<"$*")
printf '%d\t%s\n' $((10#${user/./} + 10#${system/./})) "${words:0:90}" >>"$THAUM_CASE_TIMES"
exit "$result"
