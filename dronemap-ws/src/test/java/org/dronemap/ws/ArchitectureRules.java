package org.dronemap.ws;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.methods;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaAnnotation;
import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.lang.reflect.RecordComponent;
import java.util.List;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.history.TelemetryColumn;
import org.dronemap.core.operation.ObjectionCode;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.virtual.UnfitCode;
import org.dronemap.proxy.endpoint.BoundedWebSocketDraft;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.problem.ObjectionProblem;
import org.dronemap.ws.problem.ProblemCode;
import org.dronemap.ws.security.CallerAuthenticator;
import org.java_websocket.client.WebSocketClient;
import org.java_websocket.drafts.Draft;
import org.java_websocket.drafts.Draft_6455;
import org.java_websocket.server.WebSocketServer;

/** The rules of the house that the compiler cannot see. */
final class ArchitectureRules {
    private ArchitectureRules() {}

    static final ArchRule CORE_KNOWS_ONLY_THE_JDK = classes()
            .that()
            .resideInAPackage("org.dronemap.core..")
            .should()
            .onlyDependOnClassesThat()
            .resideInAnyPackage("org.dronemap.core..", "java..", "org.jspecify..", "org.slf4j..")
            .as("core knows no framework and no driver");

    static final ArchRule CORE_OPENS_NO_SOCKETS = noClasses()
            .that()
            .resideInAPackage("org.dronemap.core..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.net..", "java.nio.channels..", "java.sql..", "javax..")
            .as("core has no sockets and no database");

    static final ArchRule CORE_NAMES_NO_PROTOCOL = noClasses()
            .that()
            .resideInAPackage("org.dronemap.core..")
            .should()
            .haveNameMatching("(?i).*(mavlink|roslink|soap|http|websocket|postgres).*")
            .as("no class of core names a protocol");

    static final ArchRule FLOORS_OF_CORE = layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("time")
            .definedBy("org.dronemap.core.time..")
            .layer("process")
            .definedBy("org.dronemap.core.process..")
            .layer("stored")
            .definedBy("org.dronemap.core.stored..")
            .layer("geo")
            .definedBy("org.dronemap.core.geo..")
            .layer("mission")
            .definedBy("org.dronemap.core.mission..")
            .layer("parameter")
            .definedBy("org.dronemap.core.parameter..")
            .layer("drone")
            .definedBy("org.dronemap.core.drone..")
            .layer("words")
            .definedBy(
                    "org.dronemap.core.event..",
                    "org.dronemap.core.command..",
                    "org.dronemap.core.access..",
                    "org.dronemap.core.recording..",
                    "org.dronemap.core.link..",
                    "org.dronemap.core.lease..",
                    "org.dronemap.core.audit..",
                    "org.dronemap.core.zone..",
                    "org.dronemap.core.virtual..",
                    "org.dronemap.core.operation..")
            .layer("cloud")
            .definedBy("org.dronemap.core.cloud..")
            .layer("conduct")
            .definedBy("org.dronemap.core.conduct..")
            .layer("history")
            .definedBy("org.dronemap.core.history..")
            .whereLayer("time")
            .mayNotAccessAnyLayer()
            .whereLayer("process")
            .mayNotAccessAnyLayer()
            .whereLayer("stored")
            .mayNotAccessAnyLayer()
            .whereLayer("conduct")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("history")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("cloud")
            .mayOnlyBeAccessedByLayers("conduct", "history")
            .whereLayer("words")
            .mayOnlyBeAccessedByLayers("cloud", "conduct", "history")
            .whereLayer("drone")
            .mayOnlyBeAccessedByLayers("words", "cloud", "conduct", "history")
            .whereLayer("parameter")
            .mayOnlyBeAccessedByLayers("drone", "words", "cloud", "conduct", "history")
            .whereLayer("mission")
            .mayOnlyBeAccessedByLayers("drone", "words", "cloud", "conduct", "history");

    static final ArchRule FLOORS_OF_PROXY = layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .layer("door")
            .definedBy("org.dronemap.proxy")
            .layer("record")
            .definedBy("..proxy.record")
            .layer("session")
            .definedBy("..proxy.session")
            .layer("translate")
            .definedBy("..proxy.mavlink.translate")
            .layer("procedure")
            .definedBy("..proxy.mavlink.procedure")
            .layer("signing")
            .definedBy("..proxy.signing")
            .layer("endpoint")
            .definedBy("..proxy.endpoint")
            .layer("outlet")
            .definedBy("..proxy.outlet")
            .layer("uplink")
            .definedBy("..proxy.outlet.uplink")
            .layer("client")
            .definedBy("..proxy.outlet.client")
            .layer("rights")
            .definedBy("..proxy.outlet.rights")
            .layer("wire")
            .definedBy("..proxy.roslink.wire")
            .layer("roslink")
            .definedBy("..proxy.roslink")
            .whereLayer("roslink")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("wire")
            .mayOnlyBeAccessedByLayers("roslink")
            .whereLayer("outlet")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("uplink")
            .mayOnlyBeAccessedByLayers("outlet")
            .whereLayer("client")
            .mayOnlyBeAccessedByLayers("outlet", "uplink")
            .whereLayer("rights")
            .mayOnlyBeAccessedByLayers("outlet", "uplink", "client")
            .whereLayer("door")
            .mayNotBeAccessedByAnyLayer()
            // The door of robots lies in their own room.
            .whereLayer("record")
            .mayOnlyBeAccessedByLayers("door", "roslink")
            .whereLayer("session")
            .mayOnlyBeAccessedByLayers("door", "record", "outlet", "roslink")
            .whereLayer("translate")
            .mayOnlyBeAccessedByLayers("session", "uplink")
            .whereLayer("procedure")
            .mayOnlyBeAccessedByLayers("session", "translate", "uplink")
            .whereLayer("signing")
            .mayOnlyBeAccessedByLayers("door", "session")
            .whereLayer("endpoint")
            .mayOnlyBeAccessedByLayers("door", "session", "outlet", "client", "roslink");

    static final ArchRule NO_CYCLES_IN_PROXY =
            slices().matching("org.dronemap.proxy.(**)").should().beFreeOfCycles();

    static final ArchRule NO_CYCLES_AMONG_TYPES_OF_THE_OUTLET = slices().assignedFrom(new SliceAssignment() {
                @Override
                public SliceIdentifier getIdentifierOf(JavaClass type) {
                    boolean ofTheOutlet = (type.getPackageName() + ".").startsWith("org.dronemap.proxy.outlet.");
                    return ofTheOutlet
                            ? SliceIdentifier.of(type.getName().split("\\$", 2)[0])
                            : SliceIdentifier.ignore();
                }

                @Override
                public String getDescription() {
                    return "the outlet's types, each with those within it";
                }
            })
            .should()
            .beFreeOfCycles();

    static final ArchRule HANDLERS_SAY_WHO_MAY_CALL_THEM = methods()
            .that()
            .areAnnotatedWith(new DescribedPredicate<JavaAnnotation<?>>("a mapping") {
                @Override
                public boolean test(JavaAnnotation<?> annotation) {
                    // By its name: what its class is annotated with is not read here.
                    return annotation
                            .getRawType()
                            .getName()
                            .matches("org\\.springframework\\.web\\.bind\\.annotation\\.\\w+Mapping");
                }
            })
            .should()
            .beAnnotatedWith(Access.class)
            .as("each handler says who may call it");

    static final ArchRule EACH_CODE_OF_A_PROBLEM_IS_TOLD = fields().that()
            .areDeclaredInClassesThat(new DescribedPredicate<JavaClass>("are catalogues of codes") {
                @Override
                public boolean test(JavaClass type) {
                    return type.isAssignableTo(ProblemCode.class)
                            || type.isAssignableTo(ObjectionCode.class)
                            || type.isEquivalentTo(OutcomeCode.class)
                            || type.isEquivalentTo(UnfitCode.class);
                }
            })
            .should(new ArchCondition<JavaField>("be told by something else than the catalogue") {
                @Override
                public void check(JavaField field, ConditionEvents events) {
                    JavaClass catalogue = field.getOwner();
                    boolean isCode = field.getRawType().equals(catalogue);
                    boolean told = field.getAccessesToSelf().stream()
                            .anyMatch(access -> !access.getOriginOwner().equals(catalogue));
                    if (isCode && !told) {
                        events.add(SimpleConditionEvent.violated(field, field.getFullName() + " is told by nothing"));
                    }
                }
            })
            .as("each code of the catalogue of problems is told by something");

    static final ArchRule EACH_OBJECTION_IS_IN_THE_CATALOGUE = classes()
            .that()
            .implement(ObjectionCode.class)
            .should(new ArchCondition<JavaClass>("be listed by " + ObjectionProblem.class.getSimpleName()) {
                @Override
                public void check(JavaClass codes, ConditionEvents events) {
                    boolean listed = codes.getDirectDependenciesToSelf().stream()
                            .anyMatch(use -> use.getOriginClass().isEquivalentTo(ObjectionProblem.class));
                    if (!listed) {
                        events.add(SimpleConditionEvent.violated(codes, codes.getName() + " is not in the catalogue"));
                    }
                }
            });

    static final ArchRule ONLY_THE_WIRING_SEES_LINKS_AND_STORES = noClasses()
            .that()
            .resideInAPackage("org.dronemap.ws..")
            .and()
            .resideOutsideOfPackages(
                    "org.dronemap.ws.wiring..", "org.dronemap.ws.server..", "org.dronemap.ws.settings..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.dronemap.proxy..", "org.dronemap.store..", "org.dronemap.mavlink..");

    static final ArchRule NO_CYCLES =
            slices().matching("org.dronemap.(*).(**)").should().beFreeOfCycles();

    static final ArchRule ONLY_THE_GATE_COMMANDS = noClasses()
            .that()
            .haveNameNotMatching(".*\\.core\\.cloud\\.CommandDispatcher")
            .and()
            // Hands on to the autopilot's session what the gate has given to that of another component.
            .haveNameNotMatching(".*\\.proxy\\.session\\.AutopilotTakeover")
            .should()
            .callMethodWhere(new DescribedPredicate<JavaCall<?>>("it is a vehicle channel's perform") {
                @Override
                public boolean test(JavaCall<?> call) {
                    JavaClass owner = call.getTargetOwner();
                    return owner.isAssignableTo(VehicleChannel.class)
                            && call.getName().equals("perform");
                }
            })
            .as("only the dispatch behind the gate calls a vehicle channel's perform");

    static final ArchRule PASSWORDS_ARE_COMPARED_IN_ONE_PLACE = noClasses()
            .that()
            .areNotAssignableTo(CallerAuthenticator.class)
            .should()
            .callMethod(PasswordHashing.class, "matches", String.class, String.class)
            .as("passwords are compared in one place, which slows down who guesses");

    static final ArchRule STORED_TEXT_HAS_NAMES_OF_ITS_OWN = noClasses()
            .that()
            .resideInAnyPackage("org.dronemap.store..", "org.dronemap.ws.journal..")
            .should()
            .accessTargetWhere(new DescribedPredicate<JavaAccess<?>>("it asks for a name of the code") {
                @Override
                public boolean test(JavaAccess<?> access) {
                    JavaClass owner = access.getTargetOwner();
                    boolean ours =
                            owner.isEquivalentTo(Enum.class) || owner.getName().startsWith("org.dronemap.");
                    // Each enum has a valueOf that the compiler wrote.
                    boolean compilers =
                            access.getOriginOwner().isEnum() && access.getName().equals("valueOf");
                    return switch (access.getName()) {
                        case "name", "valueOf", "toString" -> ours && !compilers && owner.isAssignableTo(Enum.class);
                        case "getName", "getSimpleName" ->
                            owner.isEquivalentTo(Class.class) || owner.isEquivalentTo(RecordComponent.class);
                        default -> false;
                    };
                }
            })
            .as("what is stored has names of its own: those of @Stored");

    static final ArchRule CORE_STORES_NO_NAMES_OF_CLASSES = noClasses()
            .that()
            .resideInAnyPackage("org.dronemap.core..", "org.dronemap.cognitive..")
            .should()
            .callMethod(Class.class, "getSimpleName");

    static final ArchRule CONSTANTS_THAT_STORES_KNOW_HAVE_STORED_NAMES = classes()
            .that()
            .resideInAPackage("org.dronemap.store..")
            .should(new ArchCondition<>("know only enums of ours that have stored names") {
                @Override
                public void check(JavaClass store, ConditionEvents events) {
                    for (Dependency dependency : store.getDirectDependenciesFromSelf()) {
                        JavaClass type = dependency.getTargetClass();
                        // What stands in a column is decided by its kind; no kind is written down.
                        boolean named = !type.isEnum()
                                || type.isEquivalentTo(TelemetryColumn.Kind.class)
                                || !type.getPackageName().startsWith("org.dronemap.core.")
                                || type.isAnnotatedWith(Stored.class)
                                || type.tryGetMethod("word").isPresent();
                        events.add(new SimpleConditionEvent(dependency, named, dependency.getDescription()));
                    }
                }
            });

    static final ArchRule MESSAGES_OF_WEBSOCKETS_ARE_BOUNDED = noClasses()
            .that()
            .areNotAssignableTo(BoundedWebSocketDraft.class)
            .should()
            .callCodeUnitWhere(new DescribedPredicate<JavaCall<?>>("it opens a WebSocket that says nothing of bounds") {
                @Override
                public boolean test(JavaCall<?> call) {
                    JavaClass owner = call.getTargetOwner();
                    boolean draft = owner.isEquivalentTo(Draft_6455.class);
                    boolean end =
                            owner.isEquivalentTo(WebSocketServer.class) || owner.isEquivalentTo(WebSocketClient.class);
                    return call.getName().equals("<init>")
                            && (draft
                                    || end
                                            && call.getTarget().getRawParameterTypes().stream()
                                                    .noneMatch(type -> type.isEquivalentTo(List.class)
                                                            || type.isAssignableTo(Draft.class)));
                }
            })
            .as("messages of WebSockets are bounded while they grow");
}
