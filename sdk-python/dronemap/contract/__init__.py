"""The contract with a server, as its description has it: types, and a typed call for each operation."""
