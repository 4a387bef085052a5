"""The thesis by the numbers of its figures and tables: what is printed there, what these programs make of it, both drawn."""
