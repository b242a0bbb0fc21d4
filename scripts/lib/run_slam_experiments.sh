# Runs the experiments on SLAM as a whole. Needs common.sh and run_experiments.sh.

SLAM_PROGRAM=$EXPERIMENTS_TREE/benchmark/slam_experiments
LOGS=${OMEGA_SLAM_DATA:-}/logs
SLAM_PARTS=(accuracy throughput growth simulation hostile)
SLAM_CONFIG=() # options that name parameters other than the built in ones
PART_TABLES=$EXPERIMENTS_TREE/parts # of single runs

# Logs of which much is known. Name -> file, below LOGS.
declare -A LOG_FILES=(
  [intel_first]=intel/intel_5505_first1088s_rawodom.clf
  [intel_full]=intel/intel_2726_fullrun_rawodom.clf
  [csail]=mit-csail/mit-csail.clf
  [aces]=aces/aces_440_rawodom.clf
  [freiburg_101]=freiburg-101/freiburg-101_292_rawodom.clf
  [mines]=mines/exp1.dat
)
# What gmapping has made of them.
declare -A CORRECTED_FILES=(
  [csail]=mit-csail/csail.corrected.log
  [aces]=aces/aces-corrected.log.gz
  [freiburg_101]=freiburg-101/freiburg-101-corrected.log.gz
)

# log_arguments NAME: fills LOG_ARGUMENTS; false where the log is not to be had.
log_arguments() {
  local file=$LOGS/${LOG_FILES[$1]}
  [[ -f $file ]] || return 1
  LOG_ARGUMENTS=("$file" --name "$1")
  [[ $1 != intel_* ]] || LOG_ARGUMENTS+=(--relations "$LOGS/intel/intel.relations"
    --odometry "$LOGS/intel/intel_13631_rawodom.odom")
}

# Runs that wait for their turn: arguments, quoted, and the table that each goes into.
QUEUE=()
QUEUED_TABLES=()

# queue TABLE ARGUMENT...: a run of the program whose rows go into that table.
queue() {
  QUEUED_TABLES+=("$1")
  shift
  QUEUE+=("${*@Q}")
}

# run_queued NUMBER: the run of that number; its rows into a file.
run_queued() {
  local -a words
  eval "words=(${QUEUE[$1]})"
  OMP_NUM_THREADS=1 "$SLAM_PROGRAM" "${SLAM_CONFIG[@]}" "${words[@]}" \
    >"$PART_TABLES/$1.csv" 2>>"$LOG_DIR/experiment_slam.log" </dev/null
}

stop_queue() {
  trap - EXIT INT TERM HUP
  local process
  for process in $(jobs -p); do kill "$process" 2>/dev/null || true; done
  wait
}

# run_queue JOBS: all that was queued, so many at once; tables come out in the order of the queue.
run_queue() {
  local jobs=$1 number running=0 done=0
  rm -rf "$PART_TABLES"
  mkdir -p "$PART_TABLES"
  trap stop_queue EXIT
  trap 'exit 130' INT TERM HUP
  for ((number = 0; number < ${#QUEUE[@]} + jobs; ++number)); do
    if ((number >= jobs && done < ${#QUEUE[@]})); then
      wait -n || die 'An experiment has failed:' "$(tail -n 3 "$LOG_DIR/experiment_slam.log")"
      done=$((done + 1))
      show_progress 'runs' "$done" "${#QUEUE[@]}"
    fi
    if ((number < ${#QUEUE[@]})); then run_queued "$number" & fi
  done
  finish_progress
  trap - EXIT INT TERM HUP
  for ((number = 0; number < ${#QUEUE[@]}; ++number)); do
    append_rows "$PART_TABLES/$number.csv" "$TABLES/${QUEUED_TABLES[$number]}.csv"
  done
}

# append_rows ROWS TABLE: with the head of the first.
append_rows() {
  if [[ -f $2 ]]; then tail -n +2 "$1" >>"$2"; else cp "$1" "$2"; fi
}

# queue_accuracy LOG...
queue_accuracy() {
  local name
  for name in "$@"; do
    if log_arguments "$name"; then
      queue accuracy log "${LOG_ARGUMENTS[@]}"
    else
      say "Without $name: OMEGA_SLAM_DATA does not lead to its log."
    fi
  done
}

# queue_walls LOG...: with their pictures.
queue_walls() {
  local name file corrected
  for name in "$@"; do
    log_arguments "$name" || continue
    corrected=()
    file=${CORRECTED_FILES[$name]:-}
    if [[ -n $file && -f $LOGS/$file ]]; then
      gzip -dcf "$LOGS/$file" >"$TABLES/$name.log"
      corrected=(--gmapping "$TABLES/$name.log")
    fi
    queue walls walls "${LOG_ARGUMENTS[@]}" "${corrected[@]}" --out "$TABLES"
  done
}

# run_throughput ROUNDS LOG...: one at a time, for times count.
run_throughput() {
  local rounds=$1 name
  shift
  for name in "$@"; do
    log_arguments "$name" || continue
    say "  throughput: $name"
    python3 "$OMEGA_SLAM_ROOT/benchmark/peers/offline_tool.py" "${LOG_ARGUMENTS[0]}" --name "$name" \
      --program "$EXPERIMENTS_TREE/omega_slam_offline" "${SLAM_CONFIG[@]}" --rounds "$rounds" \
      >"$TABLES/rows" || die "The offline tool has failed on $name."
    append_rows "$TABLES/rows" "$TABLES/throughput.csv"
    "$SLAM_PROGRAM" "${SLAM_CONFIG[@]}" ratio "${LOG_ARGUMENTS[@]}" >"$TABLES/rows" ||
      die "The matches have failed on $name."
    append_rows "$TABLES/rows" "$TABLES/ratio.csv"
  done
}

# queue_drives SEEDS NOISES WORLD...: a run for each seed.
queue_drives() {
  local seeds=$1 noises=$2 world seed
  shift 2
  for world in "$@"; do
    for ((seed = 1; seed <= seeds; ++seed)); do
      queue simulation simulation --world "$OMEGA_SLAM_ROOT/maps/$world.world.yaml" \
        --first-seed "$seed" --noise "$noises" --seconds 2000
    done
  done
}

# queue_lasers SEEDS SECONDS LASER...: lasers other than the TurtleBot's, with the worst odometry.
queue_lasers() {
  local seeds=$1 seconds=$2 world laser seed
  shift 2
  for world in lab office; do
    for laser in "$@"; do
      for ((seed = 1; seed <= seeds; ++seed)); do
        queue simulation simulation --world "$OMEGA_SLAM_ROOT/maps/$world.world.yaml" \
          --laser "$laser" --first-seed "$seed" --noise 4 --seconds "$seconds"
      done
    done
  done
}

# queue_hostile: the log that is densest, and a drive.
queue_hostile() {
  queue hostile hostile --world "$OMEGA_SLAM_ROOT/maps/lab.world.yaml"
  ! log_arguments intel_first || queue hostile hostile "${LOG_ARGUMENTS[@]}"
}

# run_slam_experiments QUICK JOBS PART...
run_slam_experiments() {
  local quick=$1 jobs=$2 part
  shift 2
  new_tables
  for part in "$@"; do
    case $part-$quick in
      accuracy-true) queue_accuracy intel_first intel_full ;;
      accuracy-false)
        queue_accuracy "${!LOG_FILES[@]}"
        queue_walls csail aces freiburg_101 mines
        ;;
      throughput-true) run_throughput 1 intel_first ;;
      throughput-false) run_throughput 3 intel_first intel_full csail ;;
      growth-*) ! log_arguments csail || queue growth growth "${LOG_ARGUMENTS[@]}" ;;
      simulation-true) queue_drives 2 1,4 lab && queue_lasers 1 90 rplidar utm ;;
      simulation-false)
        queue_drives 10 1,2,4 lab office maze corridor
        queue_lasers 3 300 sick rplidar lds kinect utm
        ;;
      hostile-*) queue_hostile ;;
    esac
  done
  run_queue "$jobs"
  for part in "$@"; do describe_run >"$TABLES/run_$part.csv"; done
}
