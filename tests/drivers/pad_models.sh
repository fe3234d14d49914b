#!/usr/bin/env bash
# tests/drivers/pad_models.sh PAD_MODELS: twenty models of SDL's table, drawn by a fixed seed and emulated by
# umockdev, and two with mappings of a player's own, work as pads (drivers/pad_models.cpp). It takes a second.
# Only this test runs SDL with other pads than those of Xbox. Exits with 77 if umockdev is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
need umockdev-wrapper
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0:verify_asan_link_order=0
export SDL_GAMECONTROLLERCONFIG="030000000df000000200000001000000,Own,a:b2,leftx:a1,righttrigger:b5,platform:Linux,"
umockdev-wrapper "$1" 1 20
