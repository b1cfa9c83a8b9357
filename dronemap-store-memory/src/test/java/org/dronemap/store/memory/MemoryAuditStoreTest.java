package org.dronemap.store.memory;

import org.dronemap.core.audit.AuditStore;
import org.dronemap.store.contract.AuditStoreContract;

class MemoryAuditStoreTest extends AuditStoreContract {
    @Override
    protected AuditStore emptyStore() {
        return new MemoryAuditStore(CHAIN);
    }
}
