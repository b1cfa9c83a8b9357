package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.store.StoreException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The operating-system user that the bundled PostgreSQL runs as, since it refuses to run as root. */
sealed interface ProcessAccount {
    /** The command as that user runs it. */
    List<String> wrap(List<String> command);

    /** Makes the files of the database that user's own. */
    void own(Path path) throws IOException;

    /** As the user of the server, who is not root. */
    record Same() implements ProcessAccount {
        @Override
        public List<String> wrap(List<String> command) {
            return command;
        }

        @Override
        public void own(Path path) {}
    }

    /** As the server's user seen from a user namespace without any mapping, where nobody is root and all are "nobody". */
    record UserNamespace(int uid) implements ProcessAccount {
        static final List<String> PREFIX = List.of("unshare", "--user");

        @Override
        public List<String> wrap(List<String> command) {
            return joined(PREFIX, command);
        }

        @Override
        public void own(Path path) throws IOException {
            FileTree.giveTo(path, uid);
        }
    }

    /**
     * As an account without rights, where user namespaces are not to be had: in a chroot, in most containers.
     *
     * @param reachesByRight the directory lies below one that the account may not enter (such as /root), so the
     *     processes get the one right of reading past directories
     */
    record Account(int uid, int gid, boolean reachesByRight) implements ProcessAccount {
        @Override
        public List<String> wrap(List<String> command) {
            List<String> prefix =
                    new ArrayList<>(List.of("setpriv", "--reuid=" + uid, "--regid=" + gid, "--clear-groups"));
            if (reachesByRight) {
                // Without that bit access(2), which PostgreSQL asks about its programs, would ignore the right.
                prefix.addAll(List.of(
                        "--securebits=+no_setuid_fixup",
                        "--inh-caps=+dac_read_search",
                        "--ambient-caps=+dac_read_search"));
            }
            prefix.add("--");
            return joined(prefix, command);
        }

        @Override
        public void own(Path path) throws IOException {
            FileTree.giveTo(path, uid);
        }
    }

    Logger LOG = LoggerFactory.getLogger(ProcessAccount.class);
    String ACCOUNT = "dronemap";
    Duration SHORT = Duration.ofSeconds(20);

    /** The way that this machine allows for a database in {@code directory}. */
    static ProcessAccount of(Path directory) {
        int uid = effectiveUid(directory);
        boolean named = ToolResult.of(List.of("id", "-un"), directory, SHORT).succeeded();
        if (uid != 0 && named) {
            return new Same();
        }
        if (ToolResult.of(joined(UserNamespace.PREFIX, List.of("true")), directory, SHORT)
                .succeeded()) {
            return new UserNamespace(uid);
        }
        if (uid != 0) {
            throw new StoreException(
                    "PostgreSQL refuses to run as user " + uid + ", which has no name on this machine; "
                            + "start the server as a user of /etc/passwd or give it a database with DRONEMAP_DATABASE_URL.");
        }
        return account(directory);
    }

    /** The account {@value #ACCOUNT}, created when it is not there. */
    static ProcessAccount account(Path directory) {
        if (!ToolResult.of(List.of("id", "-u", ACCOUNT), directory, SHORT).succeeded()) {
            LOG.info("Creating the system account \"{}\", because PostgreSQL refuses to run as root", ACCOUNT);
            ToolResult created = ToolResult.of(
                    List.of(
                            "useradd",
                            "--system",
                            "--user-group",
                            "--no-create-home",
                            "--home-dir=/nonexistent",
                            "--shell=/usr/sbin/nologin",
                            ACCOUNT),
                    directory,
                    SHORT);
            if (!created.succeeded()) {
                throw new StoreException("PostgreSQL refuses to run as root, this machine allows no user namespaces, "
                        + "and the account \"" + ACCOUNT + "\" cannot be created (" + created.output()
                        + "); start the server as an ordinary user or give it a database with DRONEMAP_DATABASE_URL.");
            }
        }
        boolean beyondReach = !everybodyMayEnter(directory);
        Account account = new Account(number("-u", directory), number("-g", directory), beyondReach);
        ToolResult tried = ToolResult.of(account.wrap(List.of("true")), directory, SHORT);
        if (!tried.succeeded()) {
            throw new StoreException("PostgreSQL refuses to run as root, and it cannot be run as the account \""
                    + ACCOUNT
                    + "\" in " + directory + " (" + tried.output() + "); start the server as an ordinary user, name a "
                    + "directory that everybody may enter, or give it a database with DRONEMAP_DATABASE_URL.");
        }
        return account;
    }

    private static int number(String option, Path directory) {
        ToolResult run = ToolResult.of(List.of("id", option, ACCOUNT), directory, SHORT);
        try {
            return Integer.parseInt(run.output());
        } catch (NumberFormatException e) {
            throw new StoreException("Cannot look up the account \"" + ACCOUNT + "\": " + run.output(), e);
        }
    }

    private static int effectiveUid(Path directory) {
        try {
            Path probe = Files.createTempFile(directory, "owner", ".probe");
            try {
                return (Integer) Files.getAttribute(probe, "unix:uid", LinkOption.NOFOLLOW_LINKS);
            } finally {
                Files.delete(probe);
            }
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot write into the data directory " + directory, e);
        }
    }

    private static boolean everybodyMayEnter(Path directory) {
        try {
            for (Path path = directory; path != null; path = path.getParent()) {
                if (!Files.getPosixFilePermissions(path).contains(PosixFilePermission.OTHERS_EXECUTE)) {
                    return false;
                }
            }
            return true;
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot look at the data directory " + directory, e);
        }
    }

    private static List<String> joined(List<String> first, List<String> second) {
        List<String> all = new ArrayList<>(first);
        all.addAll(second);
        return List.copyOf(all);
    }
}
