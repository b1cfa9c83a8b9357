-- Drones that went from one organisation to another, for what was before is not the new owners' to see.
-- No references: it outlives the drone, whose recordings and commands stay, and the organisations.
CREATE TABLE drone_gift (
    drone_id          text NOT NULL,
    -- As it was called then.
    drone_name        text NOT NULL,
    from_organisation text NOT NULL,
    to_organisation   text NOT NULL,
    given_at          timestamptz NOT NULL,
    -- Whether the new owners see, without names of people, what the givers saw.
    histories         boolean NOT NULL,
    PRIMARY KEY (drone_id, given_at)
);

-- Who made a key is an account: names are used again.
ALTER TABLE robot_key ADD COLUMN made_by_account text;
UPDATE robot_key SET made_by_account = coalesce(
    (SELECT account.id FROM account
     WHERE account.name = robot_key.made_by AND NOT EXISTS (
         SELECT FROM reused_name WHERE reused_name.name = account.name AND robot_key.made_at <= reused_name.removed_at)),
    made_by);
ALTER TABLE robot_key ALTER COLUMN made_by_account SET NOT NULL;

ALTER TABLE invitation ADD COLUMN invited_by_account text;
UPDATE invitation SET invited_by_account = coalesce(
    (SELECT account.id FROM account
     WHERE account.name = invitation.invited_by
         AND NOT EXISTS (SELECT FROM reused_name WHERE reused_name.name = account.name)),
    invited_by);
ALTER TABLE invitation ALTER COLUMN invited_by_account SET NOT NULL;
