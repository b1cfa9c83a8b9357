package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import javax.sql.DataSource;
import org.dronemap.core.audit.AuditChain;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditHead;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.time.FatalErrors;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes changes to the database together with the audit records of them, each pair in one transaction. Since every
 * record needs the hash of the one before, one thread writes them all; what waits for it goes together, so that a slow
 * disk is waited for once and not by each. Any thread may hand work in.
 */
final class AuditLedger implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(AuditLedger.class);
    private static final int CAPACITY = 10_000;
    private static final int MOST_AT_ONCE = 200;
    private static final String TAKEN = "23505";

    private final DataSource dataSource;
    private final DatabaseWritability writability;
    private final BlockingQueue<QueuedWrite> queue = new ArrayBlockingQueue<>(CAPACITY);
    private final BlockingQueue<AuditEntry> late = new ArrayBlockingQueue<>(CAPACITY);
    private volatile @Nullable AuditChain chain;
    private volatile @Nullable AuditHead head;
    private volatile boolean closing;
    private final Thread thread = FatalErrors.onDuty(new Thread(this::run, "ledger"));

    /** A change; says how many rows it changed. */
    interface DatabaseChange {
        int on(Connection connection) throws SQLException;
    }

    /** The result of a write: rows changed, and the audit record if there were any. */
    record WriteResult(int rows, @Nullable AuditRecord record) {}

    /** Null for a record without a change. */
    private record QueuedWrite(
            @Nullable DatabaseChange change, AuditEntry entry, CompletableFuture<WriteResult> done) {}

    AuditLedger(DataSource dataSource, DatabaseWritability writability) {
        this.dataSource = dataSource;
        this.writability = writability;
        thread.setDaemon(true);
    }

    void open(AuditChain with) {
        chain = with;
        head = AuditRows.head(new SqlTransactions(dataSource, this));
        thread.start();
    }

    /** Before it is, changes are written without records. */
    boolean isOpen() {
        return chain != null && !closing;
    }

    WriteResult write(AuditEntry entry, DatabaseChange change) {
        return await(new QueuedWrite(change, entry, new CompletableFuture<>()));
    }

    AuditRecord append(AuditEntry entry) {
        AuditRecord record =
                await(new QueuedWrite(null, entry, new CompletableFuture<>())).record();
        if (record == null) {
            throw new IllegalStateException("nothing was appended");
        }
        return record;
    }

    void appendLater(AuditEntry entry) {
        if (!late.offer(entry)) {
            LOG.error("There is no room to keep this until the database is back: {}", entry);
        }
    }

    /** A change without a record was written. */
    void unauditedWritten(int rows) {
        if (rows > 0) {
            writability.succeeded();
        }
    }

    void failed(SQLException alone) {
        writability.failed(alone);
    }

    AuditHead head() {
        AuditHead known = head;
        return known != null ? known : AuditRows.head(new SqlTransactions(dataSource, this));
    }

    private WriteResult await(QueuedWrite work) {
        if (!isOpen() || !queue.offer(work)) {
            throw new StoreException("The server is overloaded or stops; this was not written down.");
        }
        try {
            return work.done().join();
        } catch (CompletionException e) {
            Throwable why = e.getCause() == null ? e : e.getCause();
            throw why instanceof SQLException sql
                    ? SqlErrorMessages.exception(sql)
                    : new StoreException("It could not be written: " + why.getMessage(), why);
        }
    }

    // From here on: the ledger's thread.

    private void run() {
        while (!closing || !queue.isEmpty() || !late.isEmpty()) {
            try {
                List<QueuedWrite> batch = next();
                if (!batch.isEmpty()) {
                    write(batch);
                }
                if (closing && queue.isEmpty()) {
                    return;
                }
            } catch (InterruptedException e) {
                // Nobody has a reason to: it goes on, as nothing would be written down without it.
                LOG.warn("The ledger was interrupted");
            }
        }
    }

    private List<QueuedWrite> next() throws InterruptedException {
        QueuedWrite first = queue.poll(closing ? 0 : 200, TimeUnit.MILLISECONDS);
        List<QueuedWrite> batch = new ArrayList<>();
        List<AuditEntry> kept = new ArrayList<>();
        late.drainTo(kept, MOST_AT_ONCE);
        kept.forEach(entry -> batch.add(new QueuedWrite(null, entry, retryOnOutage(entry))));
        if (first != null) {
            batch.add(first);
            queue.drainTo(batch, MOST_AT_ONCE);
        }
        return batch;
    }

    private CompletableFuture<WriteResult> retryOnOutage(AuditEntry entry) {
        CompletableFuture<WriteResult> done = new CompletableFuture<>();
        CompletableFuture<WriteResult> unused = done.whenComplete((written, failure) -> {
            if (failure instanceof SQLException e && (SqlErrorMessages.isOutOfReach(e) || SqlErrorMessages.isFull(e))) {
                appendLater(entry);
            } else if (failure != null) {
                LOG.error("This could not be written down: {}", entry, failure);
            }
        });
        return done;
    }

    private void write(List<QueuedWrite> batch) {
        try {
            List<WriteResult> written = commit(batch);
            writability.succeeded();
            for (int i = 0; i < batch.size(); i++) {
                batch.get(i).done().complete(written.get(i));
            }
        } catch (SQLException e) {
            boolean outdated = TAKEN.equals(e.getSQLState()) && head != null;
            head = null;
            writability.failed(e);
            failed(batch, e, outdated);
        } catch (RuntimeException e) {
            head = null;
            LOG.error("The ledger failed", e);
            batch.forEach(work -> work.done().completeExceptionally(e));
        }
    }

    private void failed(List<QueuedWrite> batch, SQLException e, boolean outdated) {
        if (SqlErrorMessages.isOutOfReach(e) || SqlErrorMessages.isFull(e)) {
            // Nobody waits for a second try in vain.
            List<QueuedWrite> all = new ArrayList<>(batch);
            queue.drainTo(all);
            all.forEach(work -> work.done().completeExceptionally(e));
        } else if (batch.size() > 1 || outdated) {
            batch.forEach(work -> write(List.of(work)));
        } else {
            batch.get(0).done().completeExceptionally(e);
        }
    }

    private List<WriteResult> commit(List<QueuedWrite> batch) throws SQLException {
        AuditChain links = chain;
        if (links == null) {
            throw new IllegalStateException("the ledger is not open");
        }
        try (Connection connection = dataSource.getConnection()) {
            connection.setAutoCommit(false);
            AuditHead known = head;
            AuditHead at = known != null ? known : AuditRows.head(connection);
            List<WriteResult> written = new ArrayList<>();
            for (QueuedWrite work : batch) {
                WriteResult one = one(connection, work, links, at);
                AuditRecord record = one.record();
                at = record != null && record.sequence() > at.sequence() ? record.head() : at;
                written.add(one);
            }
            connection.commit();
            head = at;
            return written;
        }
    }

    private static WriteResult one(Connection connection, QueuedWrite work, AuditChain links, AuditHead at)
            throws SQLException {
        DatabaseChange change = work.change();
        int rows = change == null ? 1 : change.on(connection);
        if (rows == 0) {
            return new WriteResult(0, null);
        }
        AuditEntry entry = work.entry();
        if (entry.endsItsCommand()) {
            Optional<AuditRecord> ended = AuditRows.endingOf(connection, entry.command());
            if (ended.isPresent()) {
                return new WriteResult(rows, ended.get());
            }
            entry = entry.endingOf(AuditRows.sequenceOf(connection, entry.command()));
        }
        AuditRecord record = links.next(at, entry);
        AuditRows.insert(connection, record);
        return new WriteResult(rows, record);
    }

    /** What was handed in before is still written. */
    @Override
    public void close() {
        closing = true;
        try {
            thread.join(TimeUnit.SECONDS.toMillis(10));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
