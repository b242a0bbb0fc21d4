# Builds and runs the demo on a ROS master of its own. Needs common.sh and build.sh.

DEMO_TREE=$OMEGA_SLAM_ROOT/build/demo

# is_number TEXT: true for 0, 3 and 2.5.
is_number() { [[ $1 =~ ^[0-9]+(\.[0-9]+)?$ ]]; }

# build_demo JOBS
build_demo() {
  configure_tree "$DEMO_TREE" -DWITH_ROS=ON -DBUILD_TESTING=OFF -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    "-DCATKIN_DEVEL_PREFIX=$DEMO_TREE/devel" || die 'The demo could not be configured.'
  build_tree "$DEMO_TREE" "$1" || die 'The demo could not be built.'
}

source_devel() {
  set +u # the file uses variables that may not be set
  source "$DEMO_TREE/devel/setup.bash"
  set -u
}

# run_replay FOLDER PROGRAM ARGUMENT...: a program from test/rostest that plays bags, in a folder.
run_replay() {
  build_demo "$(default_jobs)"
  source_devel
  cd "$1"
  exec python3 "$OMEGA_SLAM_ROOT/test/rostest/$2" "${@:3}"
}

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'
}

# A ROS of our own: the caller's master, names and log folders stay out of it.
# enter_ros OUT
enter_ros() {
  source_devel
  unset ROS_HOSTNAME ROS_NAMESPACE
  export ROS_IP=127.0.0.1 # not by its name, which a bare system may not know
  ROS_MASTER_URI=http://127.0.0.1:$(free_port)
  export ROS_MASTER_URI
  export ROS_LOG_DIR=$1/log
}

# alive PROCESS
alive() { kill -0 "$1" 2>/dev/null; }

# stop PROCESS SECONDS: politely first.
stop() {
  local process=$1 tenths=$(($2 * 10))
  alive "$process" || return 0
  kill -INT "$process" 2>/dev/null || return 0
  while alive "$process" && ((tenths-- > 0)); do sleep 0.1; done
  kill -KILL "$process" 2>/dev/null || true
}

# wait_for_node NAME PROCESS: until the master knows the node that the process is to bring up.
wait_for_node() {
  local attempt
  for ((attempt = 0; attempt < 150; ++attempt)); do
    alive "$2" || return 1
    if rosnode list 2>/dev/null | grep -qx "$1"; then return 0; fi
    sleep 0.1 || true
  done
  return 1
}

# What the nodes had to say, where it matters: their warnings and errors, each once.
show_complaints() {
  grep -aE '\[ ?(WARN|ERROR|FATAL)\]|^RLException|has died' "$1" | sed -E 's/\x1b\[[0-9;]*m//g' |
    awk '!seen[$0]++' | tail -n 12
}

# Processes of the run; 0 while there is none.
MASTER=0
RECORDER=0 # run_recorder, which shows the status and saves the results
NODES=0    # roslaunch, which holds all other nodes

stop_run() {
  trap - EXIT INT TERM HUP
  local process
  for process in "$RECORDER" "$NODES" "$MASTER"; do
    ((process == 0)) || stop "$process" 25
  done
}

# start_master LOG: with time that stands still until there is a simulator.
start_master() {
  setsid roscore --port "${ROS_MASTER_URI##*:}" >"$1" 2>&1 </dev/null &
  MASTER=$!
  wait_for_node /rosout "$MASTER" && rosparam set /use_sim_time true ||
    die "The ROS master did not start. What it said is in $1."
}

# run_demo OUT WORLD DURATION ROSLAUNCH_ARGUMENT...: ends when the run ends; Ctrl-C ends it early.
#
# The recorder is there before the simulation begins, so that it misses nothing. All processes have
# sessions of their own, so that Ctrl-C in the terminal reaches this script alone: it lets the
# recorder save what the nodes have made before it stops them.
run_demo() {
  local out=$1 log=$1/log/nodes.log world=$2 duration=$3
  shift 3
  mkdir -p "$out/log"
  rm -f "$out"/{map.pgm,map.yaml,map.png,trajectory.tum,graph.g2o,report.md,report.json,timing.json}
  enter_ros "$out"
  trap stop_run EXIT
  trap 'exit 130' INT TERM HUP
  start_master "$out/log/master.log"
  setsid "$DEMO_TREE/devel/lib/omega_slam/run_recorder" \
    _world:="$world" _results:="$out" _duration:="$duration" </dev/null &
  RECORDER=$!
  wait_for_node /run_recorder "$RECORDER" || die 'run_recorder did not start.'
  setsid roslaunch omega_slam demo.launch record:=false world:="$world" results:="$out" \
    duration:="$duration" "$@" >"$log" 2>&1 </dev/null &
  NODES=$!
  watch_run "$log"
  stop_run
}

# watch_run LOG: until the recorder has ended.
watch_run() {
  local code=0
  trap 'kill -INT "$RECORDER" 2>/dev/null || true' INT TERM HUP
  while alive "$RECORDER" && alive "$NODES"; do sleep 0.3 || true; done
  if alive "$RECORDER"; then
    kill -INT "$RECORDER"
    say '' 'The nodes have ended before their time; what there is so far is saved:'
    show_complaints "$1"
    code=1
  fi
  # A signal ends `wait` before the process has ended.
  while alive "$RECORDER"; do wait "$RECORDER" || true; done
  wait "$RECORDER" || code=$?
  RECORDER=0
  ((code == 0)) || die "This run has failed. What the nodes said is in $1."
}
