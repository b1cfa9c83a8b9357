CREATE TABLE link (
    id       text PRIMARY KEY,
    url      text NOT NULL UNIQUE,
    added_by text NOT NULL,
    added_at timestamptz NOT NULL
);

-- The secret is sealed with a key that is not in the database.
CREATE TABLE link_key (
    identity      text PRIMARY KEY,
    label         text NOT NULL,
    sealed_secret text NOT NULL,
    made_by       text NOT NULL,
    made_at       timestamptz NOT NULL
);
