"""What a process has used."""
import gc
import statistics
import time


def cpuSeconds(action):
    """(processor time of all threads, result) of an action."""
    gc.disable()
    start = time.process_time()
    result = action()
    seconds = time.process_time() - start
    gc.enable()
    return seconds, result


def medianSeconds(prepare, solve, repetitions):
    """(median time of `solve`, what it returned last); whatever `prepare` returns is solved."""
    times = []
    for _ in range(repetitions):
        prepared = prepare()
        seconds, result = cpuSeconds(lambda prepared=prepared: solve(prepared))
        times.append(seconds)
    return statistics.median(times), result


def peakMegabytes():
    """Most memory that this process has held."""
    with open('/proc/self/status', encoding='ascii') as stream:
        for line in stream:
            if line.startswith('VmHWM:'):
                return float(line.split()[1]) / 1024.0
    return 0.0
