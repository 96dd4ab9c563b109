# Sourced by the window's tests: a display of its own with a window manager, in a folder that goes when the test ends.
# Sets $folder and DISPLAY; add what you start to `processes`.
folder=$(mktemp -d)
failures=0
processes=()
finish() {
    for process in "${processes[@]}"; do kill "$process" 2>/dev/null; done
    wait 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT
exec 3>"$folder/number"
Xvfb -displayfd 3 -screen 0 1400x900x24 >/dev/null 2>&1 &
processes+=($!)
for _ in $(seq 100); do [ -s "$folder/number" ] && break; sleep 0.1; done
DISPLAY=:$(cat "$folder/number")
export DISPLAY
openbox >/dev/null 2>&1 &
processes+=($!)
sleep 0.5
export XDG_CONFIG_HOME=$folder/config
