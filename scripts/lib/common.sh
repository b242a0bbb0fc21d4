# Shared by scripts/demo, scripts/test and scripts/experiments. Sourced by bash with `set -euo pipefail`.
# Sets OMEGA_SLAM_ROOT (the package) and LOG_DIR, and an environment that a pyenv, a conda or another
# workspace of the caller can't disturb.

OMEGA_SLAM_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
LOG_DIR=$OMEGA_SLAM_ROOT/build/logs
mkdir -p "$LOG_DIR"

# ROS is installed for the system's Python, which other Pythons in the PATH would hide.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
export LC_ALL=C.UTF-8
unset PYTHONPATH PYTHONHOME CMAKE_PREFIX_PATH ROS_PACKAGE_PATH

say() { printf '%s\n' "$*"; }

# die SENTENCE...: one sentence a line, then the end.
die() {
  finish_progress
  printf '%s\n' "$@" >&2
  exit 1
}

# show_progress LABEL DONE TOTAL [DETAIL]: one line that is rewritten on a terminal; elsewhere a
# line for every tenth of the way.
PROGRESS_SHOWN=''
show_progress() {
  local label=$1 done=$2 total=$3 detail=${4:-}
  if [[ -t 1 ]]; then
    local line
    printf -v line '  %s: %s of %s  %s' "$label" "$done" "$total" "$detail"
    printf '\r\033[K%s' "${line:0:$((${COLUMNS:-80} - 1))}"
    PROGRESS_SHOWN=$label
    return
  fi
  local tenth=$((total > 0 ? done * 10 / total : 0))
  if [[ $PROGRESS_SHOWN != "$label $tenth" ]]; then
    say "  $label: $done of $total"
    PROGRESS_SHOWN="$label $tenth"
  fi
}

# Leaves the line of the last show_progress behind.
finish_progress() {
  if [[ -t 1 && -n $PROGRESS_SHOWN ]]; then printf '\r\033[K'; fi
  PROGRESS_SHOWN=''
}

# How many compilers run at once: one for a processor, but each may need 1.5 GB of memory.
default_jobs() {
  local processors memory_kb by_memory
  processors=$(nproc)
  memory_kb=$(awk '/^MemTotal:/ {print $2}' /proc/meminfo)
  by_memory=$((memory_kb / 1500000))
  ((by_memory >= 1)) || by_memory=1
  say $((processors < by_memory ? processors : by_memory))
}

# is_whole_number TEXT: true for 1, 2, 3, ...
is_whole_number() { [[ $1 =~ ^[1-9][0-9]*$ ]]; }
