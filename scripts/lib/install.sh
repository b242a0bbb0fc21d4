# Installs Debian packages that are missing, such as those of scripts/dependencies.txt. Needs common.sh.

DEPENDENCY_LIST=$OMEGA_SLAM_ROOT/scripts/dependencies.txt

# listed_packages LIST: the names of all packages in a list, one a line.
listed_packages() { awk '!/^[[:space:]]*(#|$)/ {print $1}' "$1"; }

# missing_packages PACKAGE...: those that are not installed, one a line.
missing_packages() {
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
      awk '$1 == "installed" {print $2}' | sort -u)
}

# as_root COMMAND...: by sudo where the user is not root.
as_root() {
  if ((EUID == 0)); then
    "$@"
  else
    sudo "$@"
  fi
}

# Turns apt-get's status lines into a progress line.
# A status line reads <dlstatus|pmstatus>:<package>:<percent>:<what it does>.
watch_apt() {
  local line
  while IFS= read -r line; do
    if [[ $line =~ ^(dl|pm)status:[^:]*(:[^:0-9][^:]*)?:([0-9]+)[.0-9]*:(.*)$ ]]; then
      local step='download'
      [[ ${BASH_REMATCH[1]} == pm ]] && step='install'
      show_progress "$step" "${BASH_REMATCH[3]}" 100 "${BASH_REMATCH[4]}"
    fi
  done
  finish_progress
}

# The status lines have a pipe of their own, made behind sudo, which passes on no descriptors. apt-get
# makes it non-blocking: packages that shared it would fail to install whenever it is full.
run_apt() {
  as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    bash -c 'log=$1 && shift && exec apt-get "$@" 3>&1 >>"$log" 2>&1' apt-get "$LOG_DIR/apt.log" \
    -y -q -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=600 "$@" | watch_apt
}

apt_failed() {
  die "$1" "$(grep -a '^E:' "$LOG_DIR/apt.log" | tail -n 3)" \
    "All that apt-get said is in $LOG_DIR/apt.log."
}

# install_packages PACKAGE...: what is missing of them; at once done where nothing is.
install_packages() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    die 'This is not Debian: apt-get was not found.' \
      "Install what $DEPENDENCY_LIST names by other means, then build with cmake."
  local missing
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} > 0)) || return 0
  ((EUID == 0)) || command -v sudo >/dev/null ||
    die "${#missing[@]} packages are missing, and neither is this user root nor is sudo there." \
      "As root: apt-get install --no-install-recommends ${missing[*]}"

  say "Installing ${#missing[@]} missing packages and what they need: ${missing[*]}"
  : >"$LOG_DIR/apt.log"
  run_apt update || apt_failed 'The list of packages could not be updated.'
  run_apt install --no-install-recommends "${missing[@]}" ||
    apt_failed 'Packages could not be installed.'
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} == 0)) || apt_failed "Still missing after the installation: ${missing[*]}."
}

install_dependencies() {
  local packages
  mapfile -t packages < <(listed_packages "$DEPENDENCY_LIST")
  install_packages "${packages[@]}"
}
