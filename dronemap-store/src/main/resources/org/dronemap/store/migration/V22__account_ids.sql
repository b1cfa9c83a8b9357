-- What people own belongs to the id of their account, which nobody ever gets again; names are for people, and are used again.

-- Accounts of before are known by their names. New ids begin with a character that is in no name.
ALTER TABLE account ADD COLUMN id text;
UPDATE account SET id = name;

-- Names that a removed account and one of today have in common, as the record of calls tells.
CREATE TABLE reused_name (
    name       text PRIMARY KEY,
    -- When the earlier account was removed; what was there before belongs to it.
    removed_at timestamptz NOT NULL,
    -- Of today's account.
    account    text NOT NULL
);

INSERT INTO reused_name (name, removed_at, account)
SELECT account.name, max(audit.happened_at), '#' || gen_random_uuid()
FROM account JOIN audit ON audit.parameters = 'name=' || account.name
    OR audit.parameters LIKE 'name=' || replace(replace(account.name, '\', '\\'), '_', '\_') || ', %'
WHERE audit.operation = 'DELETE /api/v1/users/{name}' AND audit.outcome = 'SUCCEEDED'
GROUP BY account.name;

UPDATE account SET id = reused_name.account FROM reused_name WHERE reused_name.name = account.name;
ALTER TABLE account
    ALTER COLUMN id SET NOT NULL,
    ALTER COLUMN id SET DEFAULT '#' || gen_random_uuid(),
    ADD UNIQUE (id);

ALTER TABLE operation ADD COLUMN account text;
UPDATE operation SET account = owner;
UPDATE operation SET account = reused_name.account FROM reused_name
WHERE reused_name.name = operation.owner AND operation.began_at > reused_name.removed_at;
ALTER TABLE operation ALTER COLUMN account SET NOT NULL;

UPDATE virtual_drone SET body = jsonb_set(virtual_drone.body::jsonb, '{account}', to_jsonb(reused_name.account))::json
FROM reused_name
WHERE reused_name.name = virtual_drone.body ->> 'owner' AND virtual_drone.created_at > reused_name.removed_at;
