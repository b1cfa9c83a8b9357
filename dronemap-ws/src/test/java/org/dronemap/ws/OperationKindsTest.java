package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.OperationCodec;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.ws.server.OperationComponents;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What there is of operations is conducted, written down, and shown by each face. */
class OperationKindsTest {
    private static final JavaClasses SHIPPED = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages(
                    "org.dronemap.cognitive",
                    "org.dronemap.ws.journal",
                    "org.dronemap.ws.run",
                    "org.dronemap.ws.follow",
                    "org.dronemap.ws.dispatch",
                    "org.dronemap.ws.recovery",
                    "org.dronemap.core.operation");

    /** Where each is shown: an address of REST, an operation of SOAP, a message of the stream. */
    private static final Map<String, Shown> SHOWN = Map.of(
            "missionRun",
            new Shown("GET /api/v1/runs/{id}", "getRun", "run.RunStreamTopic$RunChanged"),
            "dispatch",
            new Shown("GET /api/v1/dispatches/{id}", "getDispatch", "dispatch.DispatchStreamTopics$DispatchChanged"),
            "recovery",
            new Shown("GET /api/v1/recoveries/{id}", "getRecovery", "recovery.RecoveryStreamTopic$RecoveryChanged"),
            "follow",
            new Shown("GET /api/v1/follows/{id}", "getFollow", "follow.FollowStreamTopics$FollowChanged"));

    private static TestServer house;

    private record Shown(String rest, String soap, String stream) {}

    @BeforeAll
    static void open() {
        house = SharedServer.get();
    }

    private static List<OperationKind<?, ?>> kinds() throws IllegalAccessException, InvocationTargetException {
        List<OperationKind<?, ?>> kinds = new ArrayList<>();
        for (RecordComponent component : OperationComponents.class.getRecordComponents()) {
            if (component.getAccessor().invoke(house.runs()) instanceof OperationKind<?, ?> kind) {
                kinds.add(kind);
            }
        }
        return kinds;
    }

    private static List<String> shipped(Class<?> type) {
        return SHIPPED.stream()
                .filter(one -> one.isAssignableTo(type) && !one.isInterface())
                .filter(one ->
                        one.getSubclasses().isEmpty() && !one.getModifiers().contains(JavaModifier.ABSTRACT))
                .map(JavaClass::getName)
                .toList();
    }

    @Test
    void conductsEachMachineAndReadsItsJournal() throws ReflectiveOperationException {
        assertThat(kinds().stream().map(kind -> kind.machine().getClass().getName()))
                .containsExactlyInAnyOrderElementsOf(shipped(Operation.class));
        assertThat(kinds().stream().map(kind -> kind.codec().getClass().getName()))
                .containsExactlyInAnyOrderElementsOf(shipped(OperationCodec.class));
        assertThat(kinds().stream().map(OperationKind::name))
                .containsExactlyInAnyOrderElementsOf(house.runs().operations().kinds());
    }

    @Test
    void showsEachKindByEachFace() throws ReflectiveOperationException {
        assertThat(kinds().stream().map(OperationKind::name)).containsExactlyInAnyOrderElementsOf(SHOWN.keySet());
        ExposedOperations faces = new ExposedOperations(house);
        assertThat(faces.rest())
                .containsAll(SHOWN.values().stream().map(Shown::rest).toList());
        assertThat(faces.soap())
                .containsAll(SHOWN.values().stream().map(Shown::soap).toList());
        assertThat(SHOWN.values()).allMatch(shown -> SHIPPED.contain("org.dronemap.ws." + shown.stream()));
    }
}
