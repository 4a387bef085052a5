"""A SLURM of one node in a folder of its own: munged, slurmctld and slurmd, started and ended by their process numbers."""
import os
import shutil
import signal
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo")

CONF = """ClusterName=one
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
CryptoType=crypto/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser=root
SlurmdUser=root
SlurmctldPort={port}
SlurmdPort={next_port}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory=1500 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """What keeps a SLURM from being started here; empty: nothing does."""
    absent = [name for name in PROGRAMS if shutil.which(name) is None]
    if absent:
        return f"{', '.join(absent)} not installed (Debian: slurm-wlm, munge)"
    return "" if os.geteuid() == 0 else "a SLURM of one's own needs root"


class OneNode:
    def __init__(self, folder):
        self.folder, self.processes = folder, []
        self.environment = os.environ | {"SLURM_CONF": os.path.join(folder, "slurm.conf")}
        for name in ("state", "spool"):
            os.makedirs(os.path.join(folder, name))
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        with open(self.environment["SLURM_CONF"], "w", encoding="utf-8") as file:
            file.write(CONF.format(host=socket.gethostname().split(".")[0], folder=folder, port=port, next_port=port + 1,
                                   cpus=os.cpu_count()))
        key = os.path.join(folder, "munge.key")
        with open(os.open(key, os.O_CREAT | os.O_WRONLY, 0o400), "wb") as file:
            file.write(os.urandom(1024))
        try:
            self._start_all(key)
        except RuntimeError:
            self.stop()
            raise

    def _start_all(self, key):
        folder = self.folder
        self._start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
                    f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed")
        self.wait_until(lambda: os.path.exists(f"{folder}/munge.socket"), "munged")
        self._start("slurmctld", "-D")
        self._start("slurmd", "-D")
        self.wait_until(lambda: "idle" in self.output("sinfo", "-h"), "the node")

    def _start(self, *words):
        with open(os.path.join(self.folder, words[0] + ".out"), "w", encoding="utf-8") as log:
            self.processes.append(subprocess.Popen(words, env=self.environment, stdout=log, stderr=log))

    @staticmethod
    def wait_until(ready, what, seconds=60):
        for _ in range(10 * seconds):
            if ready():
                return
            time.sleep(0.1)
        raise RuntimeError(f"{what} did not come")

    def output(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=60).stdout

    def submit(self, *words, **environment):
        """The job's number."""
        done = subprocess.run(["sbatch", "--parsable", *words], env=self.environment | environment, capture_output=True, text=True,
                              timeout=60)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        return done.stdout.strip().split(";")[0]

    def wait_for_all(self, seconds=900):
        self.wait_until(lambda: not self.output("squeue", "-h").strip(), "the queue's end", seconds)

    def stop(self):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGTERM)
        for process in self.processes:
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
