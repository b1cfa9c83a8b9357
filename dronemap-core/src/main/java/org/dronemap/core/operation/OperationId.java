package org.dronemap.core.operation;

/** Names one operation for ever: 1 to 64 letters, digits, dots, dashes and underscores. */
public record OperationId(String value) {
    public OperationId {
        if (!value.matches("[A-Za-z0-9._-]{1,64}")) {
            throw new IllegalArgumentException("not an id of an operation: " + value);
        }
    }

    @Override
    public String toString() {
        return value;
    }
}
