// SPDX-License-Identifier: MIT
// Makes a program of the rules alone, so that their block in docs/tutorial.md compiles like any other.
int main() {}
