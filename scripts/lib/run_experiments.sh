# Builds experiments, and publishes their results. Needs common.sh and build.sh.

EXPERIMENTS_TREE=$OMEGA_SLAM_ROOT/build/experiments
TABLES=$EXPERIMENTS_TREE/tables # of this run

# new_tables: makes the folder for them, empty.
new_tables() {
  rm -rf "$TABLES" "$LOG_DIR"/experiment_*.log
  mkdir -p "$TABLES"
}

# build_experiments JOBS [TARGET...]: from here on, no other experiments may use the tree.
build_experiments() {
  mkdir -p "$EXPERIMENTS_TREE"
  exec 9>"$EXPERIMENTS_TREE/lock"
  flock --nonblock 9 || die "Other experiments are running in $EXPERIMENTS_TREE: one at a time."
  configure_tree "$EXPERIMENTS_TREE" -DWITH_ROS=OFF -DBUILD_TESTING=OFF -DBUILD_BENCHMARKS=ON \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo || die 'The experiments could not be configured.'
  build_tree "$EXPERIMENTS_TREE" "$@" || die 'The experiments could not be built.'
}

# What the figures were made with, as a table.
describe_run() {
  local processor compiler
  processor=$(awk -F ': ' '/^model name/ {print $2; exit}' /proc/cpuinfo)
  compiler=$(awk -F = '/^CMAKE_CXX_COMPILER:/ {print $2}' "$EXPERIMENTS_TREE/CMakeCache.txt")
  say 'date,processor,processors,compiler'
  say "$(date -u +%F),${processor:-$(uname -m)},$(nproc),$("$compiler" --version | head -n 1)"
}

# publish SUBJECT OUT: draws the plots of a subject, and writes its tables into its page.
publish() {
  local subject=$1 out=$2
  mkdir -p "$out/$subject"
  describe_run >"$TABLES/run.csv"
  cp "$TABLES"/*.csv "$out/$subject/"
  cp "$TABLES"/*.png "$out/$subject/" 2>/dev/null || true # pictures that need no plotting
  PYTHONDONTWRITEBYTECODE=1 python3 "$OMEGA_SLAM_ROOT/benchmark/plots/report_$subject.py" \
    --page "$OMEGA_SLAM_ROOT/docs/experiments/$subject.md" --out "$out" ||
    die 'The plots could not be drawn.'
}
