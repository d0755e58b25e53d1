// SPDX-License-Identifier: MIT
// Completes the rules to a program, so that their block in docs/tutorial.md compiles like any
// other.
int main() {}
