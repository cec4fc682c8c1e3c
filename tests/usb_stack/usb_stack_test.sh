#!/usr/bin/env bash
# Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
# `cbvh check --backend board` inside a QEMU guest: Debian's kernel, its xHCI driver and usbfs, Debian's libusb, and the emulated board behind
# a usbredir server. Once whole, once with the board pulled out in the middle. Environment: CBVH, the command; BOARD, cbvh_usbredir; SOURCE, the
# repository's root; CBVH_KERNEL, an unpacked Debian kernel package (default: downloaded with apt-get). Runs in an empty scratch folder.
set -euo pipefail

unit=axis_compressor
cases=20000

skip() { echo "skipped: $1"; exit 77; }
for tool in qemu-system-x86_64 cpio busybox ldd; do command -v $tool >/dev/null || skip "no $tool (Debian packages qemu-system-x86 busybox-static cpio)"; done
if file=$(command -v busybox) && ldd "$file" >/dev/null 2>&1; then skip "busybox needs libraries (Debian package busybox-static)"; fi

kernel=${CBVH_KERNEL:-}
if [[ -z $kernel ]]; then
  package=$(apt-cache depends linux-image-amd64 2>/dev/null | awk '/Depends: linux-image/ {print $2; exit}') || true
  [[ $package ]] || skip "apt-cache knows no linux-image-amd64"
  apt-get -q download "$package" >download.log 2>&1 || skip "the kernel cannot be downloaded: $(tail -n 1 download.log)"
  kernel=$PWD/kernel
  dpkg-deb -x linux-image-*.deb "$kernel"
fi
vmlinuz=$(echo "$kernel"/boot/vmlinuz-*)
[[ -e $vmlinuz ]] || skip "no kernel in $kernel"

# The guest's root: busybox, the command with its libraries, one vector file, four modules.
mkdir -p root/{bin,proc,sys,dev,tmp,modules}
cp "$(command -v busybox)" root/bin/
strip -o root/bin/cbvh "$CBVH"
ldd "$CBVH" | awk '$2 == "=>" {print $3} $1 ~ /^\// {print $1}' | while read -r library; do
  mkdir -p "root$(dirname "$library")"
  cp -L "$library" "root$library"
done
for module in common/usb-common core/usbcore host/xhci-hcd host/xhci-pci; do
  cp "$kernel"/lib/modules/*/kernel/drivers/usb/$module.ko root/modules/
done
"$CBVH" gen --unit $unit --cases $cases --seed 4 -o root/vectors.bin
cat >root/init <<'TEXT'
#!/bin/busybox sh
/bin/busybox mount -t proc none /proc
/bin/busybox mount -t sysfs none /sys
/bin/busybox mount -t devtmpfs none /dev
for module in usb-common usbcore xhci-hcd xhci-pci; do /bin/busybox insmod /modules/$module.ko; done
for i in 1 2 3 4 5 6 7 8 9 10; do
  /bin/cbvh board list >/tmp/list 2>&1 && break
  /bin/busybox sleep 0.5
done
echo "guest: list: $(/bin/busybox cat /tmp/list)"
/bin/cbvh check /vectors.bin --backend board >/tmp/out 2>&1
code=$?
/bin/busybox sed 's/^/guest: /' /tmp/out
echo "guest: exit code $code"
/bin/busybox poweroff -f
TEXT
chmod +x root/init
(cd root && find . | cpio --quiet -o -H newc) >root.cpio

passed=0
failed=0
expect() {  # WHAT PATTERN FILE
  if grep -Eq -- "$2" "$3"; then
    echo "ok      $1"
    passed=$((passed + 1))
  else
    echo "FAILED  $1: no line like '$2' in:"
    tail -n 25 "$3"
    failed=$((failed + 1))
  fi
}

run_guest() {  # NAME OPTION...
  local name=$1
  shift
  "$BOARD" --socket "$PWD/$name.socket" "$@" >"$name.board" 2>&1 &
  local board=$!
  for _ in {1..100}; do if [[ -S $name.socket ]]; then break; fi; sleep 0.1; done
  timeout 180 qemu-system-x86_64 -accel tcg -machine q35 -m 512 -nodefaults -nographic -no-reboot -serial stdio \
    -kernel "$vmlinuz" -initrd root.cpio -append "console=ttyS0 quiet panic=-1" \
    -device qemu-xhci,id=xhci -chardev socket,id=board,path="$PWD/$name.socket" -device usb-redir,chardev=board,bus=xhci.0 \
    </dev/null >"$name.raw" 2>&1 || echo "qemu: exit code $?" >>"$name.raw"
  tr -d '\r' <"$name.raw" >"$name.log"
  if ! timeout 10 tail --pid=$board -f /dev/null; then kill $board; fi
  wait $board || true
}

run_guest whole
expect "the guest sees the board" "guest: list: .*1209:b5c0" whole.log
expect "every check passes through a real USB stack" "guest: .*[1-9][0-9]* passed, 0 failed" whole.log
expect "exit code 0" "guest: exit code 0$" whole.log

run_guest unplugged --unplug-after 200000
expect "a board that is pulled out is an error that says how far it got" "guest: .*unplugged.* of [0-9]+ cases were done" unplugged.log
expect "and not a pass" "guest: exit code [1-9]" unplugged.log
if grep -q "guest: .* passed, 0 failed" unplugged.log; then
  echo "FAILED  a run that was cut short reports a pass"
  failed=$((failed + 1))
fi

echo "$passed passed, $failed failed"
((failed == 0 && passed > 0))
