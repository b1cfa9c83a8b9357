package org.dronemap.store.memory;

import org.dronemap.core.operation.OperationStore;
import org.dronemap.store.contract.OperationStoreContract;

class MemoryOperationStoreTest extends OperationStoreContract {
    @Override
    protected OperationStore emptyStore() {
        return new MemoryOperationStore();
    }
}
