"""Shards started by others: GNU parallel, and Slurm with a cluster of this one machine."""
import glob
import os
import shutil
import socket
import subprocess
import time

from support import Failed, check

HERE = os.path.dirname(os.path.abspath(__file__))
CONFIGURATION = """
ClusterName=owlint
SlurmctldHost={host}
SlurmctldPort={control}
SlurmdPort={daemon}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
SwitchType=switch/none
SchedulerType=sched/backfill
SlurmctldPidFile={folder}/control.pid
SlurmdPidFile={folder}/daemon.pid
SlurmctldLogFile={folder}/control.log
SlurmdLogFile={folder}/daemon.log
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def stores(folder):
    return sorted(glob.glob(folder + "/part*.db"))


def parallel(owlint, shop, folder):
    done = subprocess.run(["parallel", "--will-cite", owlint, "audit", shop, "-q", "--shard", "{}/4", "--store", folder + "/part{}.db", ":::", "1", "2", "3", "4"],
                          capture_output=True, text=True, check=False)
    check(len(stores(folder)) == 4, "parallel: " + done.stderr)


def has_slurm():
    return os.getuid() == 0 and all(shutil.which(program) for program in ("slurmctld", "slurmd", "sbatch", "munged"))


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def slurm(owlint, shop, folder):
    """Starts a cluster of one node with a key of its own, runs the job array, and takes the cluster down again."""
    for name in ("state", "spool", "out"):
        os.makedirs("%s/%s" % (folder, name))
    os.chmod(folder, 0o755)
    with open(folder + "/munge.key", "wb") as key:
        key.write(os.urandom(128))
    os.chmod(folder + "/munge.key", 0o400)
    host = socket.gethostname().split(".")[0]
    with open(folder + "/slurm.conf", "w", encoding="utf-8") as file:
        file.write(CONFIGURATION.format(host=host, control=free_port(), daemon=free_port(), folder=folder, cpus=os.cpu_count()))
    environment = dict(os.environ, SLURM_CONF=folder + "/slurm.conf")
    started = []

    def start(*command):
        with open("%s/out/%s" % (folder, command[0]), "w", encoding="utf-8") as out:
            started.append(subprocess.Popen(command, env=environment, stdout=out, stderr=out))

    try:
        start("munged", "--foreground", "--force", "--key-file=%s/munge.key" % folder, "--socket=%s/munge.socket" % folder, "--pid-file=%s/munge.pid" % folder,
              "--seed-file=%s/munge.seed" % folder, "--log-file=%s/munge.log" % folder)
        wait_for(lambda: os.path.exists(folder + "/munge.socket"), "munged", folder)
        start("slurmctld", "-D")
        start("slurmd", "-D", "-N", host)
        wait_for(lambda: "idle" in subprocess.run(["sinfo", "-h", "-o", "%T"], env=environment, capture_output=True, text=True, check=False).stdout, "the node", folder)
        done = subprocess.run(["sbatch", "--wait", "--chdir", folder, "--export=ALL,OWLINT=%s,SHOP=%s,STORES=%s" % (owlint, shop, folder), HERE + "/job.sh"],
                              env=environment, capture_output=True, text=True, check=False, timeout=240)
        check(done.returncode == 0 and len(stores(folder)) == 4, "sbatch: %s%s" % (done.stdout, done.stderr))
    finally:
        for process in reversed(started):
            process.terminate()
        for process in started:
            process.wait()


def wait_for(ready, what, folder, seconds=60):
    end = time.monotonic() + seconds
    while not ready():
        if time.monotonic() > end:
            logs = "".join(open(name, encoding="utf-8", errors="replace").read()[-1500:] for name in glob.glob(folder + "/*.log") + glob.glob(folder + "/out/*"))
            raise Failed("%s does not start: %s" % (what, logs))
        time.sleep(0.1)
