# shellcheck shell=sh
# Shared by scripts that must leave nothing behind. A signal kills sh without its trap on EXIT, and has no effect before the
# command in the foreground has ended. So signals end the script with 128 and their number, and what takes long is attended:
#     trap 'end_attended; rm -rf "$folder"' EXIT

trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM
attended_pid=
attended_by=KILL # TERM for what has something to clean itself

# attended COMMAND...: its exit code. A signal to the script ends it, too.
attended() {
    "$@" &
    attended_pid=$!
    attended_code=0
    wait "$attended_pid" || attended_code=$?
    attended_pid=
    return "$attended_code"
}

# The cleaning that comes after it is not to be stopped.
end_attended() {
    trap '' HUP INT TERM
    [ -n "$attended_pid" ] || return 0
    kill -"$attended_by" "$attended_pid" 2>/dev/null || :
    wait "$attended_pid" 2>/dev/null || :
}
