package org.dronemap.store;

import org.dronemap.core.time.TransientFailure;
import org.jspecify.annotations.Nullable;

/** A failure to store or find something; its message is a sentence for the operator of the server. */
public final class StoreException extends RuntimeException implements TransientFailure {
    private static final long serialVersionUID = 1L;

    private final boolean passing;

    public StoreException(String sentence) {
        this(sentence, null);
    }

    public StoreException(String sentence, @Nullable Throwable cause) {
        this(sentence, cause, false);
    }

    private StoreException(String sentence, @Nullable Throwable cause, boolean passing) {
        super(sentence, cause);
        this.passing = passing;
    }

    /** The store is away or full; the same may be taken once it is back. */
    public static StoreException passing(String sentence, Throwable cause) {
        return new StoreException(sentence, cause, true);
    }

    @Override
    public boolean isTransient() {
        return passing;
    }
}
