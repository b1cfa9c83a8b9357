-- The height above sea level of the ground that a drone left last: what bounds above home are measured from.

ALTER TABLE drone ADD COLUMN ground_amsl float8;
