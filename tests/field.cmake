thaum_test(test_field
    SOURCES accuracy/field_streamline_test.cpp accuracy/field_test.cpp accuracy/field_filters_test.cpp
    accuracy/field_nrrd_random_test.cpp accuracy/field_volume_test.cpp unit/field_transfer_test.cpp unit/field_nrrd_test.cpp unit/field_nrrd_wild_test.cpp unit/field_nrrd_advice_test.cpp unit/field_volume_test.cpp
    LINK thaum_field thaum_fluid)
thaum_test(test_carving
    SOURCES unit/allocations.cpp unit/carving_history_test.cpp unit/carving_test.cpp unit/carving_tools_test.cpp unit/voxel_overlap_test.cpp unit/voxel_volume_test.cpp
        unit/voxels_test.cpp
        accuracy/carving_accuracy_test.cpp stability/carving_hostile_test.cpp
    LINK thaum_field)
