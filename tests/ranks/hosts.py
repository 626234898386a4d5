#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs a case on two hosts with one rank each, and compares the results with those of one process.

  tests/ranks/hosts.py KERF

The hosts are network namespaces of this machine with names of their own. A link of TUN devices joins
them, whose packets this program forwards a millisecond late. In a second run the link goes down: the
run must end within seconds and tell so once, and go on with one process. Ends with 77 where the user
may not make namespaces.
"""
import collections
import ctypes
import fcntl
import json
import os
import pathlib
import select
import struct
import subprocess
import sys
import tempfile
import threading
import time

SKIPPED = 77
DELAY = 1e-3  # s, of a packet
LONGEST_END = 15.0  # s, from the loss of the link to the end of mpirun
HOSTS = [f"kerf{os.getpid()}{letter}" for letter in "ab"]
DEVICE = "kerf0"
ADDRESSES = ["10.77.0.1", "10.77.0.2"]

CASE = (pathlib.Path(__file__).parent / "jet_on_strip.toml").read_text(encoding="utf-8")
# Late messages take long, so that fewer steps are made.
SHORTER = {'end = "16 ms"': 'end = "3 ms"', 'standoff = "6 mm"': 'standoff = "1 mm"',
           'frame_interval = "2 ms"': 'frame_interval = "0.5 ms"',
           'series_interval = "0.5 ms"': 'series_interval = "0.1 ms"'}


def short_case() -> str:
    """Returns the case of so few steps."""
    text = CASE
    for before, after in SHORTER.items():
        if before not in text:
            fail(f"jet_on_strip.toml has no {before}")
        text = text.replace(before, after)
    return text


def tun_device(host: str) -> int:
    """Returns a TUN device in the namespace of a host, as a file."""
    clib = ctypes.CDLL(None, use_errno=True)
    here, there = (os.open(path, os.O_RDONLY) for path in
                   ("/proc/self/ns/net", f"/run/netns/{host}"))
    set_name_without_header, tun_without_header = 0x400454CA, 0x1001
    try:
        if clib.setns(there, 0) != 0:
            raise OSError(ctypes.get_errno(), "setns")
        device = os.open("/dev/net/tun", os.O_RDWR)
        fcntl.ioctl(device, set_name_without_header,
                    struct.pack("16sH", DEVICE.encode(), tun_without_header))
        return device
    finally:
        clib.setns(here, 0)
        os.close(here)
        os.close(there)


def forward(devices: list[int]) -> None:
    """Passes the packets of each device to the other, late."""
    waiting: collections.deque = collections.deque()
    while True:
        wait = max(0.0, waiting[0][0] - time.monotonic()) if waiting else 1.0
        for device in select.select(devices, [], [], wait)[0]:
            other = devices[1] if device == devices[0] else devices[0]
            waiting.append((time.monotonic() + DELAY, other, os.read(device, 65536)))
        while waiting and waiting[0][0] <= time.monotonic():
            _, other, packet = waiting.popleft()
            try:
                os.write(other, packet)
            except OSError:
                pass  # the link is down


def ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True, stderr=subprocess.PIPE)


class Hosts:
    """Two hosts and the link between them."""

    def __enter__(self) -> "Hosts":
        for host in HOSTS:
            ip("netns", "add", host)
        threading.Thread(target=forward, args=([tun_device(host) for host in HOSTS],),
                         daemon=True).start()
        for host, address in zip(HOSTS, ADDRESSES):
            ip("-n", host, "link", "set", "lo", "up")
            ip("-n", host, "addr", "add", f"{address}/24", "dev", DEVICE)
            ip("-n", host, "link", "set", DEVICE, "up")
        return self

    def __exit__(self, *_: object) -> None:
        for host in HOSTS:
            subprocess.run(["ip", "netns", "del", host], check=False, stderr=subprocess.DEVNULL)

    @staticmethod
    def cut_link() -> None:
        ip("-n", HOSTS[1], "link", "set", DEVICE, "down")


class Program:
    """Runs of the case in a folder."""

    def __init__(self, kerf: str, folder: pathlib.Path):
        self.kerf, self.folder = kerf, folder
        (folder / "case.toml").write_text(short_case())
        # mpirun calls it in place of ssh: agent HOST WORDS
        agent = folder / "agent"
        agent.write_text(f'#!/bin/sh\nshift\nexec ip netns exec {HOSTS[1]} unshare --uts '
                         f'sh -c "hostname {HOSTS[1]}; exec sh -c \\"\\$1\\"" agent "$*"\n')
        agent.chmod(0o755)

    def words(self, name: str, *options: str) -> list[str]:
        return [self.kerf, "run", str(self.folder / "case.toml"), "--out",
                str(self.folder / name), "--threads", "1", *options]

    def alone(self, name: str, *options: str) -> None:
        subprocess.run(self.words(name, *options), check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def on_hosts(self, name: str) -> subprocess.Popen:
        mpirun = ["mpirun", "--allow-run-as-root", "-n", "2", "--host",
                  ",".join(f"{address}:1" for address in ADDRESSES),
                  "--mca", "plm_rsh_agent", str(self.folder / "agent"), "--mca", "btl", "tcp,self",
                  "--mca", "btl_tcp_if_include", DEVICE, "--mca", "oob_tcp_if_include", DEVICE,
                  "--mca", "oob_tcp_keepalive_time", "2", "--mca", "oob_tcp_keepalive_intvl", "1",
                  "--mca", "oob_tcp_keepalive_probes", "3", *self.words(name)]
        on_first = ["ip", "netns", "exec", HOSTS[0], "unshare", "--uts", "sh", "-c",
                    f'hostname {HOSTS[0]}; exec "$@"', "sh", *mpirun]
        return subprocess.Popen(on_first, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)

    def difference(self, one: str, other: str) -> str:
        """Returns the name of a result that differs; "" = none."""
        a, b = self.folder / one, self.folder / other
        if (a / "series.csv").read_bytes() != (b / "series.csv").read_bytes():
            return "series.csv"
        frames = sorted(path.name for path in (a / "frames").iterdir())
        if frames != sorted(path.name for path in (b / "frames").iterdir()):
            return "the names of the frames"
        for name in frames:
            if (a / "frames" / name).read_bytes() != (b / "frames" / name).read_bytes():
                return name
        results = [json.loads((path / "result.json").read_text()) for path in (a, b)]
        for result in results:
            del result["wall_time"], result["stage_times"]
        return "" if results[0] == results[1] else "result.json"

    def has_frames(self, name: str, count: int) -> bool:
        frames = self.folder / name / "frames"
        return frames.exists() and len(list(frames.iterdir())) >= count


def fail(message: str) -> None:
    print(f"hosts.py: error: {message}", file=sys.stderr)
    sys.exit(1)


def runs_have_the_same_bits(program: Program) -> None:
    start = time.monotonic()
    program.alone("alone")
    alone = time.monotonic() - start
    start = time.monotonic()
    run = program.on_hosts("two")
    output = run.communicate()[0]
    if run.returncode != 0:
        fail(f"the run on two hosts ended with {run.returncode}:\n{output}")
    if difference := program.difference("alone", "two"):
        fail(f"two hosts differ from one process in {difference}")
    print(f"two hosts have the bits of one process; {time.monotonic() - start:.1f} s with a link "
          f"that is {1e3 * DELAY:g} ms late, {alone:.1f} s for one process")


def a_lost_host_ends_the_run(program: Program) -> None:
    run = program.on_hosts("lost")
    while not program.has_frames("lost", 2) and run.poll() is None:
        time.sleep(0.05)
    Hosts.cut_link()
    start = time.monotonic()
    try:
        output = run.communicate(timeout=LONGEST_END)[0]
    except subprocess.TimeoutExpired:
        run.kill()
        fail(f"the run went on for {LONGEST_END:g} s without the second host")
    seconds = time.monotonic() - start
    if run.returncode == 0 or output.count("lost communication") != 1:
        fail(f"the loss was not told once; exit code {run.returncode}:\n{output}")
    program.alone("lost", "--resume")
    if difference := program.difference("alone", "lost"):
        fail(f"after the loss of a host {difference} differs")
    print(f"the loss of a host ended the run after {seconds:.1f} s; one process went on with the "
          "same bits")


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        program = Program(os.path.abspath(sys.argv[1]), pathlib.Path(folder))
        try:
            with Hosts():
                runs_have_the_same_bits(program)
                a_lost_host_ends_the_run(program)
        except (OSError, subprocess.CalledProcessError) as error:
            if isinstance(error, subprocess.CalledProcessError) and "ip" != error.cmd[0]:
                raise
            print(f"no hosts can be made here: {error}")
            sys.exit(SKIPPED)


if __name__ == "__main__":
    main()
